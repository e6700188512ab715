using System.Linq;
using Host.Assets;

namespace Host.Check
{
    /// <summary>Without its .meta file an asset of an installed package does not exist; with a GUID of another's it breaks a project.</summary>
    sealed class MetaFilesRule : Rule
    {
        public override string Name => "package: every asset has its .meta file and a GUID of its own";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            ProjectIndex index = ProjectView.Index(package);
            string root = index.Mounts[0].AssetPath + "/";
            // Files that tools write at the root of a checkout are ignored by git, so no user has them.
            foreach (string problem in index.Problems.Where(problem => !PackageTree.IsGenerated(problem.Replace(root, ""))))
                findings.Fault(problem.Replace(root, ""));
            findings.Looked = $"{index.Entries.Count} assets";
            return findings;
        }
    }
}
