using Host.Commands;

namespace Host
{
    static class Program
    {
        static int Main(string[] arguments) => CommandLine.Run("headless", "Plays scenes and runs tests of Unity projects without Unity.",
            arguments, RunCommand.Create(), TestCommand.Create());
    }
}
