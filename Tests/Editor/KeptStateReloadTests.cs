using NUnit.Framework;
using Rill.Tests;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>Work that is done before scripts are loaded again.</summary>
    public class KeptStateReloadTests
    {
        [TearDown]
        public void KeepAgain() => SolverOwner.SuspendsNothing = false;

        [Test]
        public void Disabled_fluids_give_back_what_they_keep_and_running_ones_go_on()
        {
            using (SourceScene disabled = new SourceScene(Vector3.one, 0.1f, 1000).Fill(0.2f).Step(),
                running = new SourceScene(Vector3.one, 0.1f, 1000).Fill(0.2f).Step())
            {
                GraphicsBuffer positions = disabled.Fluid.Solver.Positions;
                disabled.Fluid.gameObject.SetActive(false);
                Assert.That(positions.IsValid());
                KeptStateReload.Release();
                Assert.That(positions.IsValid(), Is.False);
                Assert.That(disabled.Fluid.HasKeptState, Is.False);
                Assert.That(running.Fluid.IsRunning);
            }
        }

        [Test]
        public void A_running_fluid_that_Unity_disables_afterwards_gives_all_back()
        {
            using (SourceScene running = new SourceScene(Vector3.one, 0.1f, 1000).Fill(0.2f).Step())
            {
                GraphicsBuffer positions = running.Fluid.Solver.Positions;
                KeptStateReload.Release();
                running.Fluid.enabled = false;
                Assert.That(positions.IsValid(), Is.False);
                Assert.That(running.Fluid.HasKeptState, Is.False);
            }
        }
    }
}
