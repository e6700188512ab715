using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.IO.Pipes;
using System.Reflection;
using System.Text.Json;
using System.Threading;
using NUnit.Framework.Internal;

namespace Host.Testing
{
    /// <summary>A process that runs those fixtures that its parent lets it have, and reports to it through a pipe. It ends when the parent
    /// does.</summary>
    sealed class TestWorker
    {
        const int ConnectMilliseconds = 60000;

        readonly NamedPipeClientStream pipe;
        readonly StreamWriter writer;
        readonly BlockingCollection<string> answers = new();
        volatile bool isDone;

        /// <param name="name">Of the parent's pipe. Not stdin and stdout: tests and the programs that they start may write there.</param>
        public TestWorker(string name)
        {
            pipe = new NamedPipeClientStream(".", name, PipeDirection.InOut);
            pipe.Connect(ConnectMilliseconds);
            writer = new StreamWriter(pipe) { AutoFlush = true };
            new Thread(Listen) { IsBackground = true }.Start();
        }

        public void Run(List<Assembly> assemblies, TestFilter filter, bool alone, bool validation, bool showsAll)
        {
            using var session = new Session(Session.Root(), scripts: assemblies, validation: validation);
            var run = new TestRun(report => Send(new WorkerMessage { Report = report }), showsAll,
                new FixtureOrder(Claim, new TestDurations(), alone), watchesStatics: true);
            foreach (Assembly assembly in assemblies)
                run.Run(assembly, filter);
            TestFacts facts = TestFacts.Of(session, run);
            isDone = true;
            Send(new WorkerMessage { Facts = facts });
        }

        bool Claim(string fixture)
        {
            Send(new WorkerMessage { Claim = fixture });
            return answers.Take() == "yes";
        }

        void Send(WorkerMessage message) => writer.WriteLine(JsonSerializer.Serialize(message));

        void Listen()
        {
            try
            {
                using var reader = new StreamReader(pipe);
                while (reader.ReadLine() is string line)
                    answers.Add(line);
            }
            catch (IOException)
            {
                // Ends as at the end of the stream.
            }
            // The parent is gone, and no one waits for the rest of a fixture.
            if (!isDone)
                Process.GetCurrentProcess().Kill();
        }
    }
}
