using System;
using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Commands;
using Host.Scripts;
using Host.Vulkan;
using UnityEngine.Headless;

namespace Host
{
    /// <summary>Runs a command, and tells what went wrong in a line. Exit codes: 0 done, 1 tests failed or the scene logged errors, 2 it
    /// could not be done, 3 GPU objects were left.</summary>
    static class CommandLine
    {
        /// <summary>Name of the program, as the user calls it.</summary>
        public static string Name { get; private set; } = "headless";

        public static int Run(string name, string description, string[] arguments, params Command[] commands)
        {
            Name = name;
            CultureOption.Use("");
            var root = new Command(name, description) { new HelpOption() };
            foreach (Command command in commands)
                root.Add(command);
            ParseResult parsed = root.Parse(arguments);
            if (parsed.Action is ParseErrorAction)
                return Fail(string.Join("; ", parsed.Errors.Select(error => error.Message.TrimEnd('.')))
                    + $"; see {name} {(parsed.CommandResult.Command == root ? "" : parsed.CommandResult.Command.Name + " ")}--help");
            try
            {
                return parsed.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false });
            }
            catch (Exception error)
            {
                return Fail(error);
            }
        }

        static int Fail(Exception error)
        {
            while (error is TargetInvocationException or TypeInitializationException or AggregateException && error.InnerException != null)
                error = error.InnerException;
            if (Environment.GetEnvironmentVariable("RILL_TRACE") == "1")
                Console.Error.WriteLine(error);
            // These messages are written for the user. Others are a fault of somebody's code, and its kind helps to find it.
            bool explained =
                error is HostException or AssetException or ScriptException or ShaderCompileException or GpuUsageException or OutOfGpuMemoryException or VulkanException;
            return Fail(explained ? error.Message : $"{error.GetType().Name}: {error.Message} (RILL_TRACE=1 shows where)");
        }

        static int Fail(string message)
        {
            Console.Error.WriteLine($"{Name}: " + message.ReplaceLineEndings(message.Contains(": error CS", StringComparison.Ordinal)
                ? "\n  " : " "));
            return 2;
        }
    }
}
