using System;
using System.IO;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>
    /// The drive and registry that wine gives to programs. Left to itself wine copies 700 MB into a new one, in 17 s, and runs
    /// a dozen services in it; a compiler needs wine's libraries under their names, drive letters, and a note that nothing is
    /// to be brought up to date.
    /// </summary>
    static class WinePrefix
    {
        const string Kernel = "kernel32.dll";

        static readonly string[] LibraryFolders =
        {
            "/usr/lib/x86_64-linux-gnu/wine/x86_64-windows", "/usr/lib/wine/x86_64-windows", "/usr/lib64/wine/x86_64-windows",
                "/opt/wine-stable/lib64/wine/x86_64-windows",
        };

        /// <param name="tryOut">Runs a program in it; it stays only when that goes well.</param>
        public static void Make(string prefix, Action tryOut)
        {
            string ready = Path.Combine(prefix, "ready"), system = Path.Combine(prefix, "drive_c", "windows", "system32"),
                drives = Path.Combine(prefix, "dosdevices");
            if (File.Exists(ready) && File.Exists(Path.Combine(system, Kernel)))    // wine may have moved since
                return;
            string libraries = LibraryFolders.FirstOrDefault(f => File.Exists(Path.Combine(f, Kernel)))
                ?? throw new FxcException($"wine's libraries are in none of {string.Join(", ", LibraryFolders)} (Debian: apt-get install wine64).");
            if (Directory.Exists(prefix))
                Directory.Delete(prefix, recursive: true);

            Directory.CreateDirectory(system);
            foreach (string library in Directory.GetFiles(libraries, "*.dll"))
                File.CreateSymbolicLink(Path.Combine(system, Path.GetFileName(library)), library);
            Directory.CreateDirectory(drives);
            Directory.CreateSymbolicLink(Path.Combine(drives, "c:"), "../drive_c");
            // Not "/", as wine has it: the compiler needs no more, and whoever deletes this cannot go astray.
            Directory.CreateSymbolicLink(Path.Combine(drives, "z:"), "../..");
            File.WriteAllText(Path.Combine(prefix, ".update-timestamp"), "disable\n");
            tryOut();
            File.WriteAllText(ready, "");
        }
    }
}
