// Stands before lavapipe (Mesa's software device) and LLVM 15, so that shaders are compiled in a fourth of the time: puts all local variables of a
// shader into one. lavapipe makes a coroutine of every compute shader, and LLVM's pass that splits coroutines builds a dominator tree of the whole
// function for each variable (`collectFrameAlloca` in llvm/lib/Transforms/Coroutines/CoroFrame.cpp; later versions build one). A long shader has
// 2,000 variables and 10,000 blocks. What shaders compute stays the same.
//
// A Vulkan driver of its own: its manifest names this library, which needs lavapipe's. lavapipe looks names up here before it looks in LLVM, so that
// it finds this `LLVMRunPasses`. `.ci/install-vulkan` builds both. Functions are declared as in llvm-c/Core.h of LLVM 15.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

typedef struct Opaque *Ref;
enum { ALLOCA = 26, LOAD = 27, STORE = 28, GET_ELEMENT_POINTER = 29, BIT_CAST = 41 };
// Variables that there is room for, and so few that they stay as they are.
enum { MOST = 16384, FEW = 32 };
// What coroutines' frames are aligned to, bytes.
enum { FRAME_ALIGNMENT = 16 };

Ref LLVMGetModuleContext(Ref module);
Ref LLVMGetModuleDataLayout(Ref module);
Ref LLVMGetFirstFunction(Ref module);
Ref LLVMGetNextFunction(Ref function);
int LLVMIsDeclaration(Ref function);
Ref LLVMGetEntryBasicBlock(Ref function);
Ref LLVMGetFirstInstruction(Ref block);
Ref LLVMGetNextInstruction(Ref instruction);
int LLVMGetInstructionOpcode(Ref instruction);
Ref LLVMGetOperand(Ref instruction, unsigned index);
Ref LLVMGetFirstUse(Ref value);
Ref LLVMGetNextUse(Ref use);
Ref LLVMGetUser(Ref use);
Ref LLVMIsAConstantInt(Ref value);
unsigned long long LLVMConstIntGetZExtValue(Ref constant);
unsigned LLVMGetAlignment(Ref instruction);
void LLVMSetAlignment(Ref instruction, unsigned bytes);
Ref LLVMGetAllocatedType(Ref alloca);
unsigned long long LLVMABISizeOfType(Ref layout, Ref type);
Ref LLVMTypeOf(Ref value);
Ref LLVMInt8TypeInContext(Ref context);
Ref LLVMInt64TypeInContext(Ref context);
Ref LLVMArrayType(Ref element, unsigned count);
Ref LLVMPointerType(Ref to, unsigned space);
Ref LLVMConstInt(Ref type, unsigned long long value, int sign);
unsigned LLVMLookupIntrinsicID(const char *name, size_t length);
Ref LLVMGetIntrinsicDeclaration(Ref module, unsigned id, Ref *types, size_t count);
Ref LLVMIntrinsicGetType(Ref context, unsigned id, Ref *types, size_t count);
Ref LLVMCreateBuilderInContext(Ref context);
void LLVMDisposeBuilder(Ref builder);
void LLVMPositionBuilderBefore(Ref builder, Ref instruction);
Ref LLVMBuildAlloca(Ref builder, Ref type, const char *name);
Ref LLVMBuildInBoundsGEP2(Ref builder, Ref type, Ref pointer, Ref *indices, unsigned count, const char *name);
Ref LLVMBuildBitCast(Ref builder, Ref value, Ref type, const char *name);
Ref LLVMBuildCall2(Ref builder, Ref type, Ref function, Ref *arguments, unsigned count, const char *name);
void LLVMReplaceAllUsesWith(Ref old, Ref new);
void LLVMInstructionEraseFromParent(Ref instruction);

// Whether an instruction is a variable of known size.
static int is_local(Ref instruction) {
    if (LLVMGetInstructionOpcode(instruction) != ALLOCA) return 0;
    Ref count = LLVMIsAConstantInt(LLVMGetOperand(instruction, 0));
    return count && LLVMConstIntGetZExtValue(count) == 1;
}

// Whether an address is used for loads and stores alone. These expect no more than frames are aligned to where `limit`.
static int is_loaded_and_stored(Ref address, int limit) {
    for (Ref use = LLVMGetFirstUse(address); use; use = LLVMGetNextUse(use)) {
        Ref user = LLVMGetUser(use);
        switch (LLVMGetInstructionOpcode(user)) {
        case STORE:
            if (LLVMGetOperand(user, 0) == address) return 0;
            // fall through
        case LOAD:
            if (limit && LLVMGetAlignment(user) > FRAME_ALIGNMENT) LLVMSetAlignment(user, FRAME_ALIGNMENT);
            break;
        case GET_ELEMENT_POINTER:
        case BIT_CAST:
            if (!is_loaded_and_stored(user, limit)) return 0;
            break;
        default: return 0;
        }
    }
    return 1;
}

// Puts the variables of a function into one, each at a multiple of its alignment.
static void merge_locals(Ref module, Ref function) {
    Ref locals[MOST];
    unsigned long long offsets[MOST], size = 0;
    unsigned count = 0;
    Ref context = LLVMGetModuleContext(module), layout = LLVMGetModuleDataLayout(module);
    Ref entry = LLVMGetEntryBasicBlock(function), first = LLVMGetFirstInstruction(entry);
    for (Ref at = first; at && count < MOST; at = LLVMGetNextInstruction(at)) {
        if (!is_local(at)) continue;
        unsigned alignment = LLVMGetAlignment(at);
        if (alignment > FRAME_ALIGNMENT) {
            if (!is_loaded_and_stored(at, 0)) continue;
            is_loaded_and_stored(at, 1);
            alignment = FRAME_ALIGNMENT;
        }
        size = (size + alignment - 1) / alignment * alignment;
        locals[count] = at;
        offsets[count++] = size;
        size += LLVMABISizeOfType(layout, LLVMGetAllocatedType(at));
    }
    if (count < FEW) return;

    Ref byte = LLVMInt8TypeInContext(context), bytes = LLVMArrayType(byte, size), address = LLVMPointerType(byte, 0);
    Ref word = LLVMInt64TypeInContext(context), zero = LLVMConstInt(word, 0, 0);
    Ref builder = LLVMCreateBuilderInContext(context);
    LLVMPositionBuilderBefore(builder, first);
    Ref all = LLVMBuildAlloca(builder, bytes, "locals");
    LLVMSetAlignment(all, FRAME_ALIGNMENT);
    // With a start of its life LLVM asks of each use whether a barrier lies between the two, without one of each pair of uses.
    unsigned start = LLVMLookupIntrinsicID("llvm.lifetime.start", strlen("llvm.lifetime.start"));
    Ref arguments[] = {LLVMConstInt(word, size, 0), LLVMBuildBitCast(builder, all, address, "")};
    Ref type = LLVMIntrinsicGetType(context, start, &address, 1);
    LLVMBuildCall2(builder, type, LLVMGetIntrinsicDeclaration(module, start, &address, 1), arguments, 2, "");
    for (unsigned k = 0; k < count; k++) {
        Ref indices[] = {zero, LLVMConstInt(word, offsets[k], 0)};
        Ref part = LLVMBuildInBoundsGEP2(builder, bytes, all, indices, 2, "");
        LLVMReplaceAllUsesWith(locals[k], LLVMBuildBitCast(builder, part, LLVMTypeOf(locals[k]), ""));
    }
    LLVMDisposeBuilder(builder);
    for (unsigned k = 0; k < count; k++) LLVMInstructionEraseFromParent(locals[k]);
}

Ref LLVMRunPasses(Ref module, const char *passes, Ref machine, Ref options) {
    Ref (*run)(Ref, const char *, Ref, Ref) = (Ref (*)(Ref, const char *, Ref, Ref))dlsym(RTLD_NEXT, "LLVMRunPasses");
    // The passes among which that of coroutines is.
    if (strncmp(passes, "default<", strlen("default<")) == 0)
        for (Ref function = LLVMGetFirstFunction(module); function; function = LLVMGetNextFunction(function))
            if (!LLVMIsDeclaration(function)) merge_locals(module, function);
    return run(module, passes, machine, options);
}
