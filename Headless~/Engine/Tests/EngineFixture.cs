using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>A fresh player for every test, and its log: a test that does not read its errors must not have any.</summary>
    public abstract class EngineFixture
    {
        readonly List<LogEntry> log = new List<LogEntry>();
        System.Action<LogEntry> writer;
        System.Func<string, Scene> loader;

        [SetUp]
        public void StartPlayer()
        {
            PlayerLoop.Reset();
            Story.Lines.Clear();
            log.Clear();
            writer = LogSink.Writer;
            loader = SceneManager.SceneLoader;
            LogSink.Writer = null;
            LogSink.Received += log.Add;
        }

        [TearDown]
        public void StopPlayer()
        {
            PlayerLoop.Reset();
            LogSink.Received -= log.Add;
            LogSink.Writer = writer;
            SceneManager.SceneLoader = loader;
            Assert.That(log.Where(e => e.Type != LogType.Log && e.Type != LogType.Warning), Is.Empty,
                "errors in the log that the test did not expect");
        }

        /// <summary>Takes the errors out of the log, which makes them expected.</summary>
        protected List<string> Errors()
        {
            List<LogEntry> errors = log.Where(e => e.Type != LogType.Log && e.Type != LogType.Warning).ToList();
            log.Clear();
            foreach (LogEntry error in errors)
                LogAssert.Expect(error.Type, error.Message);
            return errors.Select(e => e.Message).ToList();
        }

        protected List<string> Warnings() => log.Where(e => e.Type == LogType.Warning).Select(e => e.Message).ToList();

        protected static void Frames(int count, float deltaTime = 0.02f)
        {
            for (int i = 0; i < count; i++)
                PlayerLoop.Frame(deltaTime);
        }

        protected static T Add<T>(string name = "object") where T : Component => new GameObject(name).AddComponent<T>();
    }

    /// <summary>Events, in order; scripts of the tests write it.</summary>
    public static class Story
    {
        public static readonly List<string> Lines = new List<string>();
        public static void Tell(string line) => Lines.Add(line);
        public static string[] Take()
        {
            string[] lines = Lines.ToArray();
            Lines.Clear();
            return lines;
        }
    }
}
