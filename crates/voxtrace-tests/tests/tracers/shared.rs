//! Several devices share a picture: the film of one, bit for bit, whoever traced what and whoever was lost. One device is opened several times.

use std::sync::Arc;
use std::time::Duration;
use voxtrace::motion::{Moment, Moments, MovingTracer, Shot};
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Placement, Progress, Region, TraceError, Tracer};
use voxtrace_tests::moving::moving;
use voxtrace_tests::{gpu, rooms};
use voxtrace_vulkan::{Device, Fault, Faults, Options, Request, Settings, SharedTracer, VulkanTracer, choose_for};

fn device(wanted: &str, faults: Option<&Arc<Faults>>) -> VulkanTracer {
    let options = Options { faults: faults.cloned(), validation: true, ..Options::default() };
    VulkanTracer::new(Device::open(options, Some(wanted), None).unwrap(), Settings::default()).unwrap()
}

fn room() -> (Arc<PackedScene>, Frame) {
    let scene = rooms::lamp_room();
    let frame = rooms::frame(&scene, (31, 17), 1, Integrator::Essay);
    (Arc::new(PackedScene::pack(&scene).unwrap()), frame)
}

fn read(tracer: &mut dyn Tracer) -> Film {
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film).unwrap();
    film
}

fn rendered(tracer: &mut dyn Tracer, frame: &Frame) -> Film {
    let progress = Progress::default();
    tracer.render(frame, &progress).unwrap();
    read(tracer)
}

#[test]
fn devices_that_share_a_picture_give_the_film_of_one() {
    let Some(wanted) = gpu::wanted() else { return };
    let (scene, frame) = room();
    let mut shared = SharedTracer::new(vec![device(&wanted, None), device(&wanted, None)], true);
    assert_eq!(shared.names().len(), 3);
    let mut alone = CpuTracer::new(None);
    shared.set_scene(&scene).unwrap();
    alone.set_scene(&scene).unwrap();
    let crop = Region { x0: 3, y0: 2, x1: 29, y1: 16 };
    for frame in [
        // Samples are shared, or rows; from the first sample on, or another one; all of the picture, or some.
        frame.clone().samples(700).aovs(true),
        frame.clone().samples(3),
        frame.clone().samples(3).first_sample(7).region(crop).aovs(true),
        frame.clone().samples(90).first_sample(7).region(crop),
    ] {
        let film = rendered(&mut shared, &frame);
        assert!(film == rendered(&mut alone, &frame), "{} samples", frame.samples);
        assert!(film != rendered(&mut alone, &frame.clone().seed(77)), "the comparison sees another seed");
        // More of the same, which some pixels have already.
        let more = frame.clone().samples(frame.samples + 40);
        assert!(rendered(&mut shared, &more) == rendered(&mut alone, &more));
        let mut uneven = rendered(&mut alone, &frame.clone().seed(0).samples(5));
        let ahead = rendered(&mut alone, &frame.clone().seed(0).samples(9));
        uneven.pixels.iter_mut().zip(&ahead.pixels).step_by(3).for_each(|(pixel, ahead)| *pixel = *ahead);
        let evened = frame.clone().seed(0).samples(60);
        shared.resume(&evened, uneven).unwrap();
        assert!(rendered(&mut shared, &evened) == rendered(&mut alone, &evened), "pixels of 5 and 9 samples");
    }
    assert_eq!(shared.take_notes(), [""; 0]);
}

#[test]
fn a_picture_that_several_share_may_be_stopped_and_goes_on() {
    let Some(wanted) = gpu::wanted() else { return };
    let (scene, frame) = room();
    let mut shared = SharedTracer::new(vec![device(&wanted, None), device(&wanted, None)], true);
    let mut alone = CpuTracer::new(None);
    shared.set_scene(&scene).unwrap();
    alone.set_scene(&scene).unwrap();
    // Shaders are compiled once.
    shared.render(&frame.clone().samples(3).seed(9), &Progress::default()).unwrap();
    let (mut stopped, mut kept) = (0, 0);
    for samples in [4000, 16_000, 64_000] {
        // The last one where this thread came too late to stop those before.
        if samples == 64_000 && stopped > 0 {
            break;
        }
        let frame = frame.clone().samples(samples);
        let progress = Progress::default();
        std::thread::scope(|scope| {
            let render = scope.spawn(|| shared.render(&frame, &progress));
            while progress.samples_done() < u64::from(samples) * 100 && !render.is_finished() {
                std::thread::sleep(Duration::from_millis(5));
            }
            progress.cancel();
            render.join().unwrap().unwrap();
        });
        let (least, most) = read(&mut shared).sample_range();
        assert!(most <= samples, "{least} to {most} samples");
        kept += most;
        stopped += u32::from(least < samples);
        // Each pixel has the first of its samples, whatever their number.
        let upto = frame.clone().samples(most);
        assert!(rendered(&mut shared, &upto) == rendered(&mut alone, &upto), "after {least} to {most}");
    }
    assert!(stopped > 0 && kept > 0, "{stopped} were stopped, {kept} samples were kept");
    let progress = Progress::default();
    shared.render(&frame.clone().seed(3).samples(50), &progress).unwrap();
    assert_eq!(progress.samples_done(), 31 * 17 * 50, "each sample is told once");
}

#[test]
fn a_device_that_is_lost_leaves_its_part_to_the_others() {
    let Some(wanted) = gpu::wanted() else { return };
    let (scene, frame) = room();
    let frame = frame.samples(2000);
    let mut alone = CpuTracer::new(None);
    alone.set_scene(&scene).unwrap();
    let expected = rendered(&mut alone, &frame);
    for lost in [1, 2] {
        let faults: Vec<_> = (0..2).map(|_| Faults::none()).collect();
        let devices = faults.iter().map(|faults| device(&wanted, Some(faults))).collect();
        let mut shared = SharedTracer::new(devices, false);
        shared.set_scene(&scene).unwrap();
        shared.render(&frame.clone().samples(64).seed(77), &Progress::default()).unwrap();
        // Lost, and it does not come back.
        for faults in &faults[..lost] {
            faults.plant("vkQueueSubmit", Fault::DeviceLost);
            faults.plant("vkCreateDevice", Fault::OutOfHostMemory);
        }
        assert!(rendered(&mut shared, &frame) == expected, "{lost} lost");
        let notes = shared.take_notes();
        let count = |what: &str| notes.iter().filter(|note| note.contains(what)).count();
        assert_eq!((count("takes no further part"), count("the processor goes on")), (lost, lost / 2), "{notes:#?}");
        assert_eq!(shared.names().len(), 1, "{:?}", shared.names());
        assert_eq!(notes.iter().filter(|note| note.contains("does not come back")).count(), lost, "{notes:#?}");
    }
}

#[test]
fn things_move_and_scenes_change_on_all_devices() {
    let Some(wanted) = gpu::wanted() else { return };
    let (first, second) = (moving(12, 0), moving(12, 4));
    let packed = Arc::new(PackedScene::pack(&first).unwrap());
    let moved = Placement::of_scene(packed.geometry(), &second).unwrap();
    let frame = rooms::frame(&first, (24, 14), 6, Integrator::Essay);
    let moments: Moments = {
        let (still, moved, camera) = (packed.placement().clone(), moved.clone(), frame.camera.clone());
        Arc::new(move |time| {
            let placement = Some(if time < 0.5 { still.clone() } else { moved.clone() });
            Ok(Moment { camera: camera.clone(), placement })
        })
    };
    let run = |tracer: Box<dyn Tracer + Send>| -> Result<[Film; 3], TraceError> {
        let mut tracer = MovingTracer::new(tracer);
        tracer.set_scene(&packed)?;
        let still = rendered(&mut tracer, &frame);
        tracer.set_placement(&moved)?;
        let after = rendered(&mut tracer, &frame);
        tracer.set_scene(&packed)?;
        tracer.set_shot(Shot { opens: 0.0, exposure: 1.0, moments: Arc::clone(&moments) })?;
        Ok([still, after, rendered(&mut tracer, &frame)])
    };
    let shared = SharedTracer::new(vec![device(&wanted, None), device(&wanted, None)], false);
    let [still, after, blurred] = run(Box::new(shared)).unwrap();
    let expected = run(Box::new(CpuTracer::new(None))).unwrap();
    assert!(still != after && after != blurred && blurred != still, "what moves is seen to move");
    assert!([still, after, blurred] == expected);
}

#[test]
fn devices_are_named_by_their_numbers_and_a_scene_that_fits_none_goes_to_the_processor() {
    let Some(wanted) = gpu::wanted().filter(|wanted| wanted.parse::<u32>().is_ok()) else { return };
    let (scene, frame) = room();
    let mut alone = CpuTracer::new(None);
    alone.set_scene(&scene).unwrap();
    let expected = rendered(&mut alone, &frame);
    let wanted = wanted.as_str();
    let request = |device: String| Request { device: Some(device), ..Request::default() };
    let mut twice = choose_for(&request(format!("{wanted},{wanted},cpu")), &scene).unwrap();
    assert!(twice.reason.starts_with("tracing on 3 devices"), "{}", twice.reason);
    assert!(rendered(&mut *twice.tracer, &frame) == expected);
    let mut all = choose_for(&request("all".into()), &scene).unwrap();
    assert!(rendered(&mut *all.tracer, &frame) == expected, "{}", all.reason);
    let error = choose_for(&request(format!("{wanted},77")), &scene).err().unwrap().to_string();
    assert!(error.contains("77"), "{error}");
    let small = Request { memory_budget: Some(60_000), ..request(format!("{wanted},{wanted}")) };
    assert!(matches!(choose_for(&small, &scene), Err(TraceError::OutOfMemory { .. })), "asked for, it is an error");
}

#[test]
fn a_scene_that_is_set_after_all_devices_were_lost_goes_to_the_processor() {
    let Some(wanted) = gpu::wanted() else { return };
    let (scene, frame) = room();
    let mut alone = CpuTracer::new(None);
    alone.set_scene(&scene).unwrap();
    let expected = rendered(&mut alone, &frame.clone().samples(20));
    for is_earlier in [false, true] {
        let faults = Faults::none();
        let mut shared = SharedTracer::new(vec![device(&wanted, Some(&faults))], false);
        let other = Arc::new(PackedScene::pack(&moving(12, 0)).unwrap());
        shared.set_scene(&other).unwrap();
        faults.plant("vkQueueSubmit", Fault::DeviceLost);
        faults.plant("vkCreateDevice", Fault::OutOfHostMemory);
        if is_earlier {
            let lost = shared.set_placement(other.placement());
            assert!(matches!(lost, Err(TraceError::DeviceLost { .. })), "{lost:?}");
        }
        shared.set_scene(&scene).unwrap();
        assert_eq!(shared.names(), ["the processor"]);
        assert!(rendered(&mut shared, &frame.clone().samples(20)) == expected);
        let notes = shared.take_notes();
        assert!(notes.iter().any(|note| note.contains("the processor goes on")), "{notes:#?}");
    }
}
