using System.Collections;
using NUnit.Framework;
using Rill.Testing;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace Rill.Samples.Tests
{
    /// <summary>The game, played by its scripted player. Its water is coarser here than in the scene, so that it takes less time.</summary>
    [Category("LongRun")]
    public sealed class KeyInAWellTests
    {
        const float Spacing = 0.045f;       // m
        const int Capacity = 4500;
        const int Patience = 600000;        // ms, for machines without a GPU
        const float Aim = 0.17f;            // beside the key, m

        WellGame game;
        FluidSimulation fluid;
        ScriptedPlayer player;
        Transform key;

        [UnitySetUp]
        public IEnumerator Open()
        {
            Time.captureDeltaTime = 1f / 60f;
            yield return Load("d3267cc9dc48bba8938fa3c69e539e80", "KeyInAWell");
            game = Object.FindAnyObjectByType<WellGame>();
            fluid = Object.FindAnyObjectByType<FluidSimulation>();
            player = Object.FindAnyObjectByType<ScriptedPlayer>();
            key = GameObject.Find("Key").transform;
            fluid.Configure(fluid.DomainSize, Spacing, Capacity);
            fluid.GetComponent<FluidSurface>().enabled = fluid.GetComponent<FluidFoam>().enabled = Camera.main.enabled = false;
            player.RestartsAfter = 0f;
        }

        [UnityTearDown]
        public IEnumerator Leave()
        {
            Time.captureDeltaTime = 0f;
            SceneManager.CreateScene("After the game");
            yield return SceneManager.UnloadSceneAsync(game.gameObject.scene);
        }

        [UnityTest, Timeout(Patience)]
        public IEnumerator The_key_floats_out_within_ten_seconds_of_a_restart()
        {
            player.Aim = -0.6f;         // a bad beginning
            yield return Play(1f);
            player.Aim = Aim;
            int won = 0;
            game.OnWon += () => won++;
            game.Restart();
            yield return Play(10f);
            Assert.That((game.State, won), Is.EqualTo((WellState.Won, 1)));
            FluidAssert.NothingLost(fluid);
            FluidAssert.NothingEscaped(fluid);
            FluidAssert.VolumeIn(Object.FindAnyObjectByType<FluidDetector>(), 0.16f, 0.21f);       // 0.21 m³ up to the ground
            Assert.That(key.position.y, Is.GreaterThan(0f), "above the ground");
            Assert.That(game.WaterLeft, Is.GreaterThan(0f), "a careful player has some left");
        }

        [UnityTest, Timeout(Patience)]
        public IEnumerator Water_poured_beside_the_well_loses()
        {
            player.Aim = -0.6f;
            game.Supply = 0.02f;
            bool isLost = false;
            game.OnLost += () => isLost = true;
            yield return Play(8f);
            Assert.That((game.State, isLost, game.WaterLeft), Is.EqualTo((WellState.Lost, true, 0f)));
            FluidAssert.NothingLost(fluid);
            FluidAssert.VolumeIn(Object.FindAnyObjectByType<FluidDetector>(), 0f, 0.02f);
            Assert.That(key.position.y, Is.LessThan(-0.5f), "still on its grate");
        }

        [UnityTest, Timeout(Patience)]
        public IEnumerator A_restart_brings_back_the_very_start()
        {
            var before = new Start[1];
            var after = new Start[1];
            player.enabled = false;
            yield return Remember(before);
            player.Aim = Aim;
            player.enabled = true;
            yield return Play(2.5f);
            Assert.That(game.WaterLeft, Is.LessThan(1f));

            player.enabled = false;
            yield return Remember(after);
            Assert.That(after[0].key, Is.EqualTo(before[0].key));
            Assert.That(after[0].tap, Is.EqualTo(before[0].tap));
            Assert.That(game.WaterLeft, Is.EqualTo(1f));
            Assert.That(after[0].fluid, Is.EqualTo(before[0].fluid), "each byte of the fluid's state");
        }

        struct Start
        {
            public byte[] fluid;
            public Vector3 key;
            public float tap;
        }

        // The state from which a game begins.
        IEnumerator Remember(Start[] to)
        {
            while (game.State == WellState.Preparing)
                yield return null;
            game.Restart();
            fluid.Paused = true;        // no step until the state is known
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            to[0].key = key.position;
            to[0].tap = game.TapX;
            yield return request;
            to[0].fluid = request.Snapshot.ToBytes();
            fluid.Paused = false;
        }

        // Until the game is over, at most so many seconds.
        IEnumerator Play(float seconds)
        {
            while (game.State == WellState.Preparing)
                yield return null;
            for (int frame = 0; frame < seconds * 60f && game.State == WellState.Playing; frame++)
                yield return null;
        }

        // By its GUID, wherever the sample was imported to; in a player by its name in the build settings.
        static AsyncOperation Load(string guid, string name)
        {
#if UNITY_EDITOR
            return UnityEditor.SceneManagement.EditorSceneManager.LoadSceneAsyncInPlayMode(UnityEditor.AssetDatabase.GUIDToAssetPath(guid),
                new LoadSceneParameters(LoadSceneMode.Single));
#else
            return SceneManager.LoadSceneAsync(name);
#endif
        }
    }
}
