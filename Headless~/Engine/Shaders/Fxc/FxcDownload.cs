using System.IO;

namespace Host.Shaders
{
    /// <summary>Source of Microsoft's compiler: an npm package that redistributes it.</summary>
    static class FxcDownload
    {
        /// <summary>Hash of the file itself, so that no other is run and results can be cached by it.</summary>
        public const string Sha256 = "289767B49DC8525BCE262EA06FEE4EF9FCED2E131A55B25654CE871C1F0498B2";
        const string Name = "d3dcompiler_47.dll";
        static readonly NpmFile File = new("webgpu@0.6.2", "dist/win32-x64/" + Name, Sha256);

        /// <param name="npm">Null when there is none.</param>
        /// <exception cref="FxcException"/>
        public static void Fetch(string folder, string npm)
        {
            string dll = Path.Combine(folder, Name);
            if (File.IsAt(dll))
                return;
            if (npm == null)
                throw new FxcException($"npm is not there; it fetches Microsoft's shader compiler, {Name} of the package " +
                    $"{File.Package} (Debian: apt-get install npm). "
                    + $"Without it, put that file, of SHA-256 {Sha256}, into {folder}.");
            File.Fetch(dll, npm);
        }
    }
}
