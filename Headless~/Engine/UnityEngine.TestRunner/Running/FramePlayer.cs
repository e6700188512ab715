using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.ExceptionServices;
using NUnit.Framework;

namespace UnityEngine.Headless
{
    /// <summary>Plays a test's coroutine on a MonoBehaviour, frame after frame of fixed length, until it ends.</summary>
    internal static class FramePlayer
    {
        public const int DefaultTimeout = 180000;
        public const float FrameTime = 1f / 60;

        static TestPlayer player;

        /// <exception cref="AssertionException">It took longer than the milliseconds, or an error was logged that nothing expects.</exception>
        public static void Play(IEnumerator routine, int timeout)
        {
            if (routine == null)
                throw new InvalidOperationException("A coroutine test returned null.");
            if (player == null)
            {
                var gameObject = new GameObject("Code-based tests runner");
                Object.DontDestroyOnLoad(gameObject);
                player = gameObject.AddComponent<TestPlayer>();
            }

            var steps = new Steps(routine);
            Coroutine coroutine = player.StartCoroutine(steps.Run());
            var clock = Stopwatch.StartNew();
            while (!steps.Ended)
            {
                PlayerLoop.Frame(FrameTime);
                if (steps.Ended)
                    break;
                if (player == null)
                    throw new AssertionException("The test destroyed the object that plays it.");
                try
                {
                    LogScope.Current.Check();
                    if (clock.ElapsedMilliseconds > timeout)
                        throw TookTooLong(timeout);
                }
                catch (AssertionException)
                {
                    player.StopCoroutine(coroutine);
                    throw;
                }
            }
            steps.Error?.Throw();
        }

        public static AssertionException TookTooLong(int timeout) =>
            new AssertionException($"Timeout value of {timeout} ms was exceeded. Use Timeout attribute if the default timeout is too short.");

        // Nested enumerators are stepped here, so that what they throw ends the test as its own exceptions do.
        sealed class Steps
        {
            readonly Stack<IEnumerator> stack = new Stack<IEnumerator>();

            public bool Ended { get; private set; }
            public ExceptionDispatchInfo Error { get; private set; }

            public Steps(IEnumerator routine) => stack.Push(routine);

            public IEnumerator Run()
            {
                // The first step, as all others, is taken where a frame resumes its coroutines.
                yield return null;
                while (Advance(out object instruction))
                    yield return instruction;
                Ended = true;
            }

            bool Advance(out object instruction)
            {
                instruction = null;
                try
                {
                    while (stack.Count > 0)
                    {
                        if (!stack.Peek().MoveNext())
                        {
                            stack.Pop();
                            continue;
                        }
                        instruction = stack.Peek().Current;
                        if (instruction is WaitForEndOfFrame)
                            throw new InvalidOperationException(
                                "WaitForEndOfFrame never resumes in batch mode, where tests run too; yield null instead.");
                        if (!(instruction is IEnumerator nested))
                            return true;
                        stack.Push(nested);
                    }
                }
                catch (Exception error)
                {
                    Error = ExceptionDispatchInfo.Capture(error);
                }
                return false;
            }
        }
    }

    internal sealed class TestPlayer : MonoBehaviour { }
}
