using System.Diagnostics;

namespace Host
{
    /// <summary>The commit that figures are measured at.</summary>
    static class SourceCommit
    {
        public const string Unknown = "unknown";

        /// <summary>Returns its name, with "-dirty" at the end where files differ; unknown outside a git repository.</summary>
        public static string Describe()
        {
            try
            {
                using var git = Process.Start(new ProcessStartInfo("git", new[] { "-C", Session.Root(), "describe", "--always", "--dirty" })
                { RedirectStandardOutput = true, RedirectStandardError = true });
                string name = git.StandardOutput.ReadToEnd().Trim();
                git.WaitForExit();
                return git.ExitCode == 0 ? name : Unknown;
            }
            catch (System.ComponentModel.Win32Exception)
            {
                return Unknown;
            }
        }
    }
}
