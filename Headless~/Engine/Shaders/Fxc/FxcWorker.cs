using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Text;

namespace Host.Shaders
{
    /// <summary>One run of fxc-worker.exe over many requests.</summary>
    sealed class FxcWorker
    {
        /// <summary>Answer as FXC gave it, to be kept in the cache.</summary>
        public sealed class Answer
        {
            public int Outcome;     // HRESULT
            public string Log;
            public byte[] Dxbc;
        }

        readonly FxcInstallation installation;
        readonly TimeSpan patience;

        /// <param name="patience">How long one request may take before FXC counts as hung.</param>
        public FxcWorker(FxcInstallation installation, TimeSpan patience)
        {
            this.installation = installation;
            this.patience = patience;
        }

        /// <summary>An answer each, in order; fewer when FXC crashed or hung on the one after the last.</summary>
        /// <param name="ending">How the process ended, for that one's message.</param>
        /// <param name="hung">True when it was stopped for its silence.</param>
        public List<Answer> Run(IReadOnlyList<FxcRequest> requests, out string ending, out bool hung)
        {
            var answers = new List<Answer>();
            string end = null;
            bool stopped = false;
            FxcInstallation.InNewFolder(installation.Folder, folder =>
            {
                // Files, not pipes: what wine starts beside the program would keep a pipe open.
                string results = Path.Combine(folder, "results");
                WriteJobs(Path.Combine(folder, "jobs"), requests);
                using Process process = installation.Start(folder);
                var said = new StringBuilder();
                process.ErrorDataReceived += (_, e) => { lock (said) said.AppendLine(e.Data); };
                process.BeginErrorReadLine();
                stopped = !Ends(process, results);
                end = stopped ? $"was stopped after {patience.TotalSeconds:0.#} s without an answer" : $"ended with code {process.ExitCode}";
                if (File.Exists(results))
                    answers = ReadAnswers(results);
                lock (said)
                    if (answers.Count == 0 && said.ToString().Trim() is { Length: > 0 } text)
                        end += ": " + text;
            });
            ending = end;
            hung = stopped;
            return answers;
        }

        bool Ends(Process process, string results)
        {
            long length = 0;
            var quiet = Stopwatch.StartNew();
            while (!process.WaitForExit(100))
            {
                long now = File.Exists(results) ? new FileInfo(results).Length : 0;
                if (now != length)
                    quiet.Restart();
                length = now;
                if (quiet.Elapsed < patience)
                    continue;
                process.Kill(entireProcessTree: true);
                process.WaitForExit(10000);
                return false;
            }
            return true;
        }

        static void WriteJobs(string path, IReadOnlyList<FxcRequest> requests)
        {
            using var writer = new BinaryWriter(File.Create(path));
            void Text(string text)
            {
                byte[] bytes = Encoding.UTF8.GetBytes(text);
                writer.Write(bytes.Length);
                writer.Write(bytes);
            }
            writer.Write(requests.Count);
            foreach (FxcRequest request in requests)
            {
                Text("source");
                Text(request.Source.Text);
                Text(request.EntryPoint);
                Text(request.Profile);
                writer.Write((uint)request.Flags);
            }
        }

        // A last answer that is cut off does not count.
        static List<Answer> ReadAnswers(string path)
        {
            var answers = new List<Answer>();
            using var reader = new BinaryReader(File.OpenRead(path));
            long Left() => reader.BaseStream.Length - reader.BaseStream.Position;
            byte[] Blob() => Left() >= 4 && reader.ReadInt32() is int length && Left() >= length ? reader.ReadBytes(length) : null;
            while (Left() >= 4)
            {
                var answer = new Answer { Outcome = reader.ReadInt32() };
                byte[] log = Blob();
                answer.Dxbc = Blob();
                if (log == null || answer.Dxbc == null)
                    break;
                answer.Log = Encoding.UTF8.GetString(log);
                answers.Add(answer);
            }
            return answers;
        }
    }
}
