"""The Python module: views of fields and what becomes of them, errors, runs, Ctrl-C, threads. Usage: test_module.py SCENES"""
import gc
import json
import os
import signal
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy

SPIN_COUNT_BEFORE = os.environ.get("GOMP_SPINCOUNT")

import sluice  # noqa: E402 - after a look at the environment

SCENES = Path(sys.argv.pop())


def gate(**options):
    return sluice.Simulation(SCENES / "small_gate.toml", **options)


def interrupt_when(ready):
    """Ctrl-C as soon as `ready` says so."""
    def wait():
        while not ready():
            time.sleep(0.001)
        os.kill(os.getpid(), signal.SIGINT)
    threading.Thread(target=wait, daemon=True).start()


class Scenes(unittest.TestCase):
    def test_from_file_and_text_are_the_same(self):
        path = SCENES / "small_gate.toml"
        from_file = sluice.Scene.from_file(str(path), set=["method.courant=0.5"])
        from_text = sluice.Scene.from_text(path.read_text(), ["method.courant=0.5"], name=str(path))
        self.assertEqual(from_file.text, from_text.text)
        self.assertEqual((from_file.title, from_file.dimension), ("Small gate", 2))
        self.assertEqual(from_file.bodies, ["tank", "gate"])
        self.assertIn("courant = 0.5", from_file.text)

    def test_errors_carry_the_engine_s_words(self):
        with self.assertRaisesRegex(sluice.SceneError, r'method\.spacng: .*did you mean "spacing"'):
            gate(set=["method.spacng=0.01"])
        with self.assertRaisesRegex(sluice.SceneError, "nowhere.toml: cannot be read: No such file"):
            sluice.Simulation("nowhere.toml")
        with self.assertRaisesRegex(sluice.SceneError, r"^here\.toml:1:"):
            sluice.Scene.from_text("title = ", name="here.toml")
        self.assertTrue(issubclass(sluice.SceneError, sluice.Error))
        self.assertEqual(sluice.SceneError.__module__, "sluice")
        with self.assertRaisesRegex(TypeError, "Scene.from_file"):
            sluice.Simulation(sluice.Scene.from_file(str(SCENES / "small_gate.toml")), set=["method.courant=0.5"])

    def test_unknown_fields(self):
        with self.assertRaisesRegex(KeyError, 'fluid: found the field .*"presure.*did you mean .*"pressure'):
            gate().fluid["presure"]
        with self.assertRaisesRegex(KeyError, "fluid: this scene has no such particles"):
            sluice.Simulation(SCENES / "breakdown.toml").fluid["pressure"]


    def test_importing_leaves_the_environment_as_it_was(self):
        self.assertEqual(os.environ.get("GOMP_SPINCOUNT"), SPIN_COUNT_BEFORE)


class Views(unittest.TestCase):
    def test_are_the_simulation_s_own_memory(self):
        simulation = gate()
        first, second = simulation.fluid["pressure"], simulation.fluid["pressure"]
        self.assertTrue(numpy.shares_memory(first, second))
        self.assertFalse(first.flags.owndata)
        self.assertEqual(first.dtype, numpy.float64)
        self.assertEqual(first.shape, (simulation.fluid.count,))
        self.assertEqual(simulation.fluid["id"].dtype, numpy.uint64)
        self.assertEqual(simulation.fluid["body"].dtype, numpy.uint16)
        self.assertEqual(simulation.solid["clamped"].dtype, numpy.uint8)
        self.assertEqual(len(simulation.fluid["position"]), 2)
        self.assertEqual(simulation.fluid.unit("pressure"), "Pa")

    def test_cannot_be_written(self):
        pressure = gate().fluid["pressure"]
        with self.assertRaises(ValueError):
            pressure[0] = 1
        with self.assertRaises(ValueError):
            pressure.setflags(write=True)

    def test_keep_the_values_of_their_moment(self):
        """Through several sorts of the particles, with all fields held, and with the memory's owner gone."""
        simulation = gate()
        held = {}
        for medium in ("fluid", "solid"):
            particles = getattr(simulation, medium)
            for name in particles:
                views = particles[name]
                for k, view in enumerate(views if isinstance(views, tuple) else (views,)):
                    held[medium, name, k] = (view, view.copy())
        order = simulation.fluid["id"].copy()
        simulation.step(300)
        self.assertFalse(numpy.array_equal(order, simulation.fluid["id"]), "the test must see a sort")
        del simulation, particles
        gc.collect()
        for key, (view, copy) in held.items():
            self.assertTrue(numpy.array_equal(view, copy), key)

    def test_a_view_outlives_its_simulation_without_a_step(self):
        pressure = gate().fluid["pressure"]
        gc.collect()
        self.assertTrue(numpy.isfinite(pressure).all())

    def test_do_not_change_the_computation(self):
        plain, watched = gate(), gate()
        plain.step(120)
        kept = []
        for _ in range(120):
            kept += [watched.fluid["position"], watched.solid["velocity"], watched.fluid["id"]]
            watched.step()
        for name in ("id", "density", "pressure"):
            self.assertTrue(numpy.array_equal(plain.fluid[name], watched.fluid[name]), name)
        for k in range(2):
            self.assertTrue(numpy.array_equal(plain.solid["position"][k], watched.solid["position"][k]))

    def test_released_views_cost_no_copy(self):
        simulation = gate()
        address = simulation.solid["mass"].ctypes.data
        simulation.step()       # no sort yet: without a holder the column stays where it is
        self.assertEqual(simulation.solid["mass"].ctypes.data, address)
        held = simulation.solid["mass"]
        simulation.step()
        self.assertEqual(held.ctypes.data, address)
        self.assertNotEqual(simulation.solid["mass"].ctypes.data, address)

    def test_agree_with_the_frame(self):
        simulation = gate()
        simulation.step(50)
        frame = simulation.frame()
        fluid = frame["phase"] == 0
        order = simulation.fluid["id"].argsort()
        x, y = simulation.fluid["position"]
        self.assertTrue(numpy.array_equal(frame["points"][fluid, 0], x[order].astype(numpy.float32)))
        self.assertTrue(numpy.array_equal(frame["points"][fluid, 1], y[order].astype(numpy.float32)))
        self.assertTrue(numpy.array_equal(frame["pressure"][fluid],
                                          simulation.fluid["pressure"][order].astype(numpy.float32)))
        self.assertEqual(set(frame["body"][fluid]), {simulation.scene.bodies.index("tank")})
        self.assertEqual(len(frame["id"]), sum(p.count for p in (simulation.fluid, simulation.solid, simulation.wall)))

    def test_the_solid_s_pressure_is_shown_only_where_it_is_kept(self):
        self.assertIn("pressure", gate().solid)             # hypoelastic
        modern = gate(set=["method.preset=\"modern\""])
        self.assertNotIn("pressure", modern.solid)          # follows from the deformation; the frame has it
        self.assertEqual(len(modern.solid["deformation"]), 4)
        self.assertTrue(numpy.isfinite(modern.frame()["von_mises"]).all())


class Stepping(unittest.TestCase):
    def test_time_energy_probes(self):
        simulation = gate()
        start = simulation.energy["total"]
        simulation.advance_to(0.005)
        self.assertAlmostEqual(simulation.time, 0.005, delta=simulation.time_step)
        self.assertGreater(simulation.steps, 10)
        self.assertLess(abs(simulation.energy["total"] - start), 0.1 * abs(start))   # it falls by dissipation only
        self.assertEqual(len(simulation.momentum), 3)
        self.assertTrue(all(numpy.isfinite(v) for v in simulation.probes.values()))
        self.assertEqual(simulation.warnings, [])

    def test_a_time_is_a_number(self):
        for never in (float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "expected a time"):
                gate().advance_to(never)

    def test_breakdown_is_an_error(self):
        simulation = sluice.Simulation(SCENES / "breakdown.toml")
        with self.assertRaises(sluice.NumericalError):
            simulation.advance_to(simulation.scene.end_time)

    def test_ctrl_c_between_steps(self):
        simulation = gate()
        start = time.monotonic()
        interrupt_when(lambda: time.monotonic() > start + 0.3)
        with self.assertRaises(KeyboardInterrupt):
            simulation.step(10**9)
        steps = simulation.steps
        self.assertGreater(steps, 0)
        simulation.step()       # it may go on
        self.assertEqual(simulation.steps, steps + 1)

    def test_other_threads_run_meanwhile_and_are_refused(self):
        simulation = gate()
        worker = threading.Thread(target=simulation.step, args=(2000,))
        worker.start()
        refused = counted = 0
        while worker.is_alive():
            counted += 1
            try:
                simulation.fluid["pressure"].sum()
            except RuntimeError as error:
                self.assertIn("another thread", str(error))
                refused += 1
            time.sleep(0.001)
        worker.join()
        self.assertGreater(refused, 0)
        self.assertEqual(simulation.steps, 2000)


class Runs(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self.scratch.name) / "run"
        self.addCleanup(self.scratch.cleanup)

    def test_files_and_summary(self):
        summary = sluice.run(SCENES / "small_gate.toml", self.folder, until=0.004)
        self.assertEqual(summary["status"], "done")
        self.assertEqual(summary["version"], sluice.__version__)
        self.assertTrue((self.folder / "probes.csv").exists())

    def test_stopped_and_gone_on_with(self):
        probes = self.folder / "probes.csv"
        interrupt_when(lambda: probes.exists() and probes.stat().st_size > 1000)
        with self.assertRaises(KeyboardInterrupt):
            sluice.run(SCENES / "small_gate.toml", self.folder, until=1000)  # never there, however slow the disk is
        stopped = json.loads((self.folder / "summary.json").read_text())
        self.assertEqual(stopped["status"], "interrupted")
        end = stopped["simulated_time"] + 0.01
        self.assertEqual(sluice.resume(self.folder, until=end)["status"], "done")
        whole = Path(self.scratch.name) / "whole"
        sluice.run(SCENES / "small_gate.toml", whole, until=end)
        self.assertEqual(probes.read_bytes(), (whole / "probes.csv").read_bytes())

    def test_failures(self):
        with self.assertRaises(sluice.NumericalError):
            sluice.run(SCENES / "breakdown.toml", self.folder)
        self.assertEqual(json.loads((self.folder / "summary.json").read_text())["status"], "failed")
        with self.assertRaises(sluice.OutputError):
            sluice.run(SCENES / "small_gate.toml", "/proc/nowhere")
        with self.assertRaisesRegex(sluice.CheckpointError, "nowhere"):
            sluice.resume("nowhere")


if __name__ == "__main__":
    unittest.main()
