using System;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace UnityEngine.Headless
{
    /// <summary>The messages of one phase of a test (before it, the test itself, after it) and what it expects of them.</summary>
    internal sealed class LogScope
    {
        static LogScope current;
        static readonly object gate = new object();

        readonly List<ReceivedLog> received = new List<ReceivedLog>();
        readonly Queue<ExpectedLog> expected = new Queue<ExpectedLog>();

        public bool IgnoreFailing;

        /// <exception cref="InvalidOperationException">No test is running.</exception>
        public static LogScope Current => current ?? throw new InvalidOperationException("LogAssert works only while a test runs.");

        /// <summary>Starts a phase, forgetting what the last one received and expected.</summary>
        public static void Begin()
        {
            lock (gate)
                current = new LogScope();
        }

        public static void End()
        {
            lock (gate)
                current = null;
        }

        /// <summary>Takes the scope away while tests of the runner itself run; <see cref="Resume"/> puts it back.</summary>
        public static LogScope Suspend()
        {
            lock (gate)
            {
                LogScope scope = current;
                current = null;
                return scope;
            }
        }

        public static void Resume(LogScope scope)
        {
            lock (gate)
                current = scope;
        }

        /// <summary>For Application.logMessageReceivedThreaded.</summary>
        public static void Receive(string message, string stackTrace, LogType type)
        {
            lock (gate)
                current?.received.Add(new ReceivedLog { Message = message, StackTrace = stackTrace, Type = type });
        }

        public void Expect(ExpectedLog log)
        {
            lock (gate)
                expected.Enqueue(log);
        }

        /// <summary>Fails on an error that nothing expects; may be called during a phase.</summary>
        public void Check()
        {
            lock (gate)
            {
                Match();
                if (IgnoreFailing)
                    return;
                foreach (ReceivedLog log in received)
                    if (log.Fails && !log.Expected)
                        throw new AssertionException(
                            $"Unhandled log message: '{log}'. Use UnityEngine.TestTools.LogAssert.Expect\n{log.StackTrace}".TrimEnd());
            }
        }

        /// <summary>Works like <see cref="Check"/>, and every expectation must have been met.</summary>
        public void CheckAtEnd()
        {
            Check();
            lock (gate)
                if (expected.Count > 0)
                    throw new AssertionException($"Expected log did not appear: {expected.Peek()}");
        }

        public void NoUnexpectedReceived()
        {
            lock (gate)
            {
                Match();
                foreach (ReceivedLog log in received)
                    if (!log.Expected)
                        throw new AssertionException($"Unhandled log message: '{log}'. Use UnityEngine.TestTools.LogAssert.Expect");
            }
        }

        // Expectations are met in their order; messages between them are passed over.
        void Match()
        {
            foreach (ReceivedLog log in received)
            {
                if (expected.Count == 0)
                    return;
                if (!log.Expected && expected.Peek().Matches(log))
                {
                    expected.Dequeue();
                    log.Expected = true;
                }
            }
        }
    }

    internal sealed class ReceivedLog
    {
        public string Message, StackTrace;
        public LogType Type;
        public bool Expected;
        public bool Fails => Type == LogType.Error || Type == LogType.Assert || Type == LogType.Exception;
        public override string ToString() => $"[{Type}] {Message}";
    }

    internal sealed class ExpectedLog
    {
        readonly LogType? type;
        readonly string message;
        readonly Regex pattern;

        public ExpectedLog(LogType? type, string message, Regex pattern) { this.type = type; this.message = message; this.pattern = pattern; }

        public bool Matches(ReceivedLog log) => (type == null || type == log.Type)
            && (pattern != null ? pattern.IsMatch(log.Message) : log.Message == message);

        public override string ToString() => $"[{(type == null ? "Any" : type.ToString())}] {(pattern != null ? "Regex: " + pattern : message)}";
    }
}
