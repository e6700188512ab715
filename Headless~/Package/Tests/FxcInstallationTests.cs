using System;
using System.IO;
using System.Linq;
using Host.Check;
using Host.Shaders;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Reports when Microsoft's compiler cannot run, with tools that are missing or false.</summary>
    public sealed class FxcInstallationTests
    {
        const string Gcc = "x86_64-w64-mingw32-gcc";

        string folder, cache, tools;

        [SetUp]
        public void Start()
        {
            folder = Directory.CreateTempSubdirectory("rill-fxc-tests-").FullName;
            cache = Directory.CreateDirectory(Path.Combine(folder, "cache")).FullName;
            tools = Directory.CreateDirectory(Path.Combine(folder, "tools")).FullName;
        }

        [TearDown]
        public void End() => Directory.Delete(folder, recursive: true);

        string Refusal() => Assert.Throws<FxcException>(() => new FxcInstallation(cache, new[] { tools })).Message;

        void Script(string name, string body)
        {
            string path = Path.Combine(tools, name);
            File.WriteAllText(path, "#!/bin/sh\n" + body);
            File.SetUnixFileMode(path, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }

        // The real compiler, which other tests have fetched.
        void RemoveDll()
        {
            _ = new FxcInstallation(ShaderCache.DefaultFolder(), FxcInstallation.ToolFolders);
            Directory.CreateDirectory(Path.Combine(cache, "fxc"));
            File.Copy(Path.Combine(ShaderCache.DefaultFolder(), "fxc", "d3dcompiler_47.dll"), Path.Combine(cache, "fxc", "d3dcompiler_47.dll"));
        }

        static FxcRequest Request(string name) => new FxcRequest
        {
            Name = name, EntryPoint = "K", EntryLine = new SourceLine(name, 1), Profile = "cs_5_0",
            Source = new PreprocessedSource { Text = $"// {name}\n[numthreads(1,1,1)] void K() {{}}\n" },
        };

        [Test]
        public void Missing_wine_is_named_with_its_package()
        {
            Assert.That(Refusal(), Does.Contain("wine64 is not there").And.Contain("apt-get install wine64"));
        }

        [Test]
        public void A_missing_compiler_for_Windows_is_named_with_its_package()
        {
            Script("wine64", "exit 0\n");
            Assert.That(Refusal(), Does.Contain(Gcc + " is not there").And.Contain("apt-get install gcc-mingw-w64-x86-64"));
        }

        [Test]
        public void Missing_npm_is_named_with_its_package_and_the_file_it_fetches()
        {
            Script("wine64", "exit 0\n");
            Script(Gcc, "touch fxc-worker.exe\n");
            Assert.That(Refusal(), Does.Contain("npm is not there").And.Contain("apt-get install npm").And.Contain(
                "d3dcompiler_47.dll").And.Contain(Path.Combine(cache, "fxc")));
        }

        [Test]
        public void A_compiler_that_does_not_build_the_worker_is_quoted()
        {
            Script("wine64", "exit 0\n");
            Script(Gcc, "echo no such header >&2; exit 1\n");
            Assert.That(Refusal(), Does.Contain(Gcc).And.Contain("failed with code 1: no such header"));
        }

        [Test]
        public void A_changed_compiler_is_not_used()
        {
            Script("wine64", "exit 0\n");
            Script(Gcc, "touch fxc-worker.exe\n");
            // npm pack webgpu@... --silent --pack-destination <folder>
            Script("npm", "mkdir -p \"$5/package/dist/win32-x64\" && echo false > \"$5/package/dist/win32-x64/d3dcompiler_47.dll\" && " +
                "tar -czf \"$5/webgpu.tgz\" -C \"$5\" package\n");
            Assert.That(Refusal(), Does.Contain("has SHA-256").And.Contain(FxcDownload.Sha256));
            Assert.That(File.Exists(Path.Combine(cache, "fxc", "d3dcompiler_47.dll")), Is.False);
        }

        [Test]
        public void A_wine_that_does_not_run_the_compiler_is_quoted()
        {
            RemoveDll();
            Script("wine64", "echo broken pipe organ >&2; exit 9\n");
            Script(Gcc, "touch fxc-worker.exe\n");
            Assert.That(Refusal(), Does.Contain("cannot run Microsoft's shader compiler here: broken pipe organ"));
        }

        [Test]
        public void A_missing_tool_is_one_fault_of_the_rule()
        {
            using (var package = new SyntheticPackage().Add("A.compute", "#pragma kernel K\n[numthreads(1,1,1)] void K() {}\n"))
                Assert.That(new FxcRule(cache, new[] { tools }, new FxcAllowance[0]).Examine(package.Tree).Faults.Single(),
                    Does.Contain("apt-get install wine64"));
        }

        // The real one, whose wine first runs some lines of shell.
        FxcCompiler Compiler(string first)
        {
            RemoveDll();
            string wine = FxcInstallation.ToolFolders.SelectMany(f => new[] { "wine64", "wine" }, Path.Combine).First(File.Exists);
            File.CreateSymbolicLink(Path.Combine(tools, Gcc), FxcInstallation.ToolFolders.Select(f => Path.Combine(f, Gcc)).First(File.Exists));
            Script("wine64", first + "\nexec " + wine + " \"$@\"\n");
            return new FxcCompiler(cache, new[] { tools });
        }

        // Wine prints this when its server ends while it connects.
        [Test]
        public void A_wine_that_dies_is_started_again()
        {
            string deaths = Path.Combine(folder, "deaths");
            var results = Compiler($"if [ $(wc -c < jobs) -gt 4 ] && [ $(cat {deaths} 2> /dev/null | wc -l) -lt 2 ]; " +
                $"then echo >> {deaths}; exit 1; fi").CompileAll(new[] { Request("one"), Request("two") });
            Assert.That(results.Select(r => r.Success), Is.EqualTo(new[] { true, true }));
            Assert.That(File.ReadAllText(deaths).Length, Is.EqualTo(2), "deaths");
        }

        [Test]
        public void A_crash_is_said_of_the_shader_that_it_happened_on_and_the_rest_is_compiled()
        {
            // Dies when the first of its jobs is the one called "poison".
            var results = Compiler("if head -c 80 jobs | grep -q poison; then exit 7; fi")
                .CompileAll(new[] { Request("poison"), Request("one"), Request("two") });
            Assert.That(results.Select(r => r.Success), Is.EqualTo(new[] { false, true, true }));
            Assert.That(results[0].Messages.Single().ToString(), Is.EqualTo("poison(1): error: FXC ended with code 7 while it compiled this"));
        }

        [Test]
        public void A_compiler_that_hangs_is_stopped()
        {
            RemoveDll();
            Script(Gcc, "touch fxc-worker.exe\n");
            Script("wine64", "if [ $(wc -c < jobs) -gt 4 ]; then exec sleep 100; fi\n");
            var worker = new FxcWorker(new FxcInstallation(cache, new[] { tools }), TimeSpan.FromSeconds(0.5));
            Assert.That(worker.Run(new[] { Request("long") }, out string ending, out bool hung), Is.Empty);
            Assert.That(hung);
            Assert.That(ending, Does.StartWith("was stopped after"));
        }

        [Test]
        public void A_container_that_is_cut_off_is_refused()
        {
            byte[] dxbc = new FxcCompiler().Compile(Request("whole")).Dxbc;
            Assert.That(new DxbcContainer(dxbc).Names, Does.Contain("RDEF").And.Contain("SHEX").And.Contain("STAT"));
            Assert.Throws<FormatException>(() => new DxbcContainer(dxbc.Take(dxbc.Length - 4).ToArray()));
            Assert.Throws<FormatException>(() => new DxbcContainer(new byte[40]));
            Assert.That(Assert.Throws<FormatException>(() => new DxbcContainer(dxbc).Chunk("SPDB")).Message, Does.Contain("no SPDB chunk"));
        }
    }
}
