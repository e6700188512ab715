using System;
using System.IO;

namespace Host.Shaders
{
    /// <summary>Answers of FXC on disk, failures too, a file each, as <see cref="ShaderCache"/> keeps programs.</summary>
    sealed class FxcCache
    {
        readonly string folder;

        public FxcCache(string cacheFolder) => folder = Directory.CreateDirectory(Path.Combine(cacheFolder, "fxc", "answers")).FullName;

        public static string Key(FxcRequest request)
            => ShaderCache.Key(FxcDownload.Sha256, request.Profile, request.EntryPoint, ((uint)request.Flags).ToString(),
            request.Source.Text);

        /// <summary>Null when it is not there.</summary>
        public FxcWorker.Answer Find(string key)
        {
            string path = Path.Combine(folder, key);
            if (!File.Exists(path))
                return null;
            try
            {
                using var reader = new BinaryReader(File.OpenRead(path));
                var answer = new FxcWorker.Answer { Outcome = reader.ReadInt32(), Log = reader.ReadString() };
                int length = reader.ReadInt32();
                answer.Dxbc = reader.ReadBytes(length);
                return answer.Dxbc.Length == length ? answer : null;
            }
            catch (EndOfStreamException)
            {
                return null;    // a file that a full disk cut short: compiled and written again
            }
        }

        public void Store(string key, FxcWorker.Answer answer)
        {
            // Whoever looks meanwhile sees the whole file or none.
            string path = Path.Combine(folder, key), partial = path + "." + Guid.NewGuid().ToString("N");
            using (var writer = new BinaryWriter(File.Create(partial)))
            {
                writer.Write(answer.Outcome);
                writer.Write(answer.Log);
                writer.Write(answer.Dxbc.Length);
                writer.Write(answer.Dxbc);
            }
            File.Move(partial, path, overwrite: true);
        }
    }
}
