using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;

namespace Host.Shaders
{
    /// <summary>Compiles HLSL as Unity's editor does on Windows: by Microsoft's FXC, under wine. Thread-safe.</summary>
    sealed class FxcCompiler
    {
        // A start of wine costs as much as some kernels.
        const int MinPerWorker = 4, MaxDeaths = 3;
        static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

        readonly FxcCache cache;
        readonly Lazy<FxcInstallation> installation;

        /// <param name="cacheFolder">Null: that of <see cref="ShaderCache"/>.</param>
        /// <param name="toolFolders">Where wine64, npm and the C compiler lie; null: on the PATH.</param>
        public FxcCompiler(string cacheFolder = null, IReadOnlyList<string> toolFolders = null)
        {
            cacheFolder ??= ShaderCache.DefaultFolder();
            cache = new FxcCache(cacheFolder);
            installation = new Lazy<FxcInstallation>(() => new FxcInstallation(cacheFolder, toolFolders ?? FxcInstallation.ToolFolders));
        }

        /// <exception cref="FxcException">FXC cannot run here.</exception>
        public FxcResult Compile(FxcRequest request) => CompileAll(new[] { request })[0];

        /// <summary>A result each, in order. What is not in the cache is compiled by as many processes as there are cores.</summary>
        /// <exception cref="FxcException">FXC cannot run here.</exception>
        public IReadOnlyList<FxcResult> CompileAll(IReadOnlyList<FxcRequest> requests)
        {
            List<string> keys = requests.Select(FxcCache.Key).ToList();
            var answers = new Dictionary<string, FxcWorker.Answer>();
            var wanted = new Dictionary<string, FxcRequest>();
            for (int i = 0; i < requests.Count; i++)
            {
                if (answers.ContainsKey(keys[i]) || wanted.ContainsKey(keys[i]))
                    continue;
                FxcWorker.Answer found = cache.Find(keys[i]);
                if (found != null)
                    answers.Add(keys[i], found);
                else
                    wanted.Add(keys[i], requests[i]);
            }

            foreach ((string key, FxcWorker.Answer answer) in Run(wanted.ToList()))
                answers.Add(key, answer);
            return requests.Select((request, i) => Result(answers[keys[i]], request)).ToList();
        }

        IEnumerable<(string, FxcWorker.Answer)> Run(List<KeyValuePair<string, FxcRequest>> wanted)
        {
            if (wanted.Count == 0)
                return Enumerable.Empty<(string, FxcWorker.Answer)>();
            _ = installation.Value;     // one thread finds what is missing and reports it
            int workers = Math.Clamp(wanted.Count / MinPerWorker, 1, Environment.ProcessorCount);
            // Dealt out in turn: the kernels of one file cost alike.
            return Enumerable.Range(0, workers)
                .Select(worker => Task.Run(() => RunOne(wanted.Where((_, i) => i % workers == worker).ToList())))
                .ToArray().SelectMany(task => task.GetAwaiter().GetResult()).ToList();
        }

        List<(string, FxcWorker.Answer)> RunOne(List<KeyValuePair<string, FxcRequest>> wanted)
        {
            var worker = new FxcWorker(installation.Value, Patience);
            var done = new List<(string, FxcWorker.Answer)>();
            int deaths = 0;     // on the first request that is not done
            while (done.Count < wanted.Count)
            {
                List<FxcWorker.Answer> answers = worker.Run(wanted.Skip(done.Count).Select(w => w.Value).ToList(), out string ending,
                    out bool hung);
                if (answers.Count > 0)
                    deaths = 0;
                foreach (FxcWorker.Answer answer in answers)
                {
                    string key = wanted[done.Count].Key;
                    cache.Store(key, answer);
                    done.Add((key, answer));
                }
                // A process can die of wine alone, whose server may end just as it connects: another one is asked, and the request
                // is to blame when that dies too. The rest gets a new process. Not kept: the next time it may be well.
                if (done.Count == wanted.Count || (!hung && ++deaths < MaxDeaths))
                    continue;
                done.Add((wanted[done.Count].Key,
                    new FxcWorker.Answer { Outcome = -1, Log = $"error: FXC {ending} while it compiled this", Dxbc = Array.Empty<byte>() }));
                deaths = 0;
            }
            return done;
        }

        static FxcResult Result(FxcWorker.Answer answer, FxcRequest request)
        {
            List<FxcMessage> messages = FxcLog.Read(answer.Log, request);
            bool success = answer.Outcome >= 0 && answer.Dxbc.Length > 0;
            if (!success && !messages.Any(m => m.IsError))
                messages.Add(new FxcMessage { IsError = true, Where = request.EntryLine,
                    Text = $"FXC failed with 0x{answer.Outcome:X8} and said no reason" });
            return new FxcResult { Dxbc = success ? answer.Dxbc : null, Messages = messages };
        }
    }
}
