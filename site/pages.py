"""Copies `docs/` for the site, with what it has beside it: its first page, a list of the decisions, and links that leave `docs/` for the repository.

    python site/pages.py FOLDER
"""

import re
import shutil
import sys
from pathlib import Path
from posixpath import normpath

REPOSITORY = "https://github.com/voxtrace/voxtrace"
HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
LINK = re.compile(r"(?<=\]\()([^)#\s]+)(#[^)\s]*)?(?=\))")


def decisions(folder: Path) -> str:
    """A list of the pages in a folder by their headings."""
    pages = sorted(folder.glob("[0-9]*.md"))
    rows = [f"- [{page.read_text().splitlines()[0].removeprefix('# ')}]({page.name})" for page in pages]
    head = "# Decisions\n\nWhat was asked, what was chosen, what was measured, and what was tried and left: a page each.\n\n"
    return head + "\n".join(rows) + "\n"


def linked(markdown: str, page: Path) -> str:
    """A page, `page` below the repository, whose links to what the site does not have go to the repository."""

    def target(match: re.Match[str]) -> str:
        link, anchor = match.group(1), match.group(2) or ""
        path = normpath(f"{page.parent}/{link}")
        if "://" in link or path.startswith("docs/") or not (ROOT / path).exists():
            return match.group(0)
        kind = "tree" if (ROOT / path).is_dir() else "blob"
        return f"{REPOSITORY}/{kind}/main/{path}{anchor}"

    return LINK.sub(target, markdown)


def main(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "docs", folder)
    for name in ("index.md", "site.css"):
        shutil.copy(HERE / name, folder)
    (folder / "decisions/index.md").write_text(decisions(ROOT / "docs/decisions"))
    for path in folder.rglob("*.md"):
        path.write_text(linked(path.read_text(), Path("docs") / path.relative_to(folder)))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
