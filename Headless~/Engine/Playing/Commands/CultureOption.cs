using System.CommandLine;
using System.Globalization;

namespace Host.Commands
{
    /// <summary><c>--culture</c>: of the user whose machine is pretended. Without it everything runs under the invariant culture, whatever the
    /// machine's language is.</summary>
    static class CultureOption
    {
        public static Option<string> Create() => new Option<string>("--culture")
        {
            Description = "Runs the tests under this culture, as de-DE or tr-TR, instead of the invariant one.", DefaultValueFactory = _ => "",
        };

        /// <summary>For all threads of this process. To be called before there are others.</summary>
        public static void Use(string name)
        {
            CultureInfo culture = Find(name);
            CultureInfo.CurrentCulture = CultureInfo.CurrentUICulture = culture;
            CultureInfo.DefaultThreadCurrentCulture = CultureInfo.DefaultThreadCurrentUICulture = culture;
        }

        static CultureInfo Find(string name)
        {
            if (name.Length == 0)
                return CultureInfo.InvariantCulture;
            if (!IsThere("en-US"))
                throw new HostException($"--culture {name}: this process has no data of cultures. Start it through the script rill, which installs " +
                    "ICU, or install libicu and unset DOTNET_SYSTEM_GLOBALIZATION_INVARIANT.");
            return IsThere(name) ? CultureInfo.GetCultureInfo(name)
                : throw new HostException($"--culture {name}: the culture does not exist; names are as de-DE or tr-TR.");
        }

        static bool IsThere(string name)
        {
            try
            {
                CultureInfo.GetCultureInfo(name, predefinedOnly: true);
                return true;
            }
            catch (CultureNotFoundException)
            {
                return false;
            }
        }
    }
}
