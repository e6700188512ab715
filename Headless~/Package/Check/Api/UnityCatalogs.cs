using System;
using System.Collections.Generic;
using System.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>The lists of every version, read once for all rules.</summary>
    static class UnityCatalogs
    {
        // Comments to a line's end stand inside of these two, on one line with what follows: not to be told from code any more.
        static readonly string[] Garbled = { "UnityEditor.TerrainTools.TerrainPaintUtilityEditor | static void DrawBrushPreview(",
            "UnityEngine.TerrainTools.TerrainPaintUtility | static void SetupTerrainToolMaterialProperties(" };

        static readonly Lazy<IReadOnlyList<ApiCatalog>> all = new(() => Make(UnityApiLists.Load(), UnityApiLists.LoadOptional()));

        public static IReadOnlyList<ApiCatalog> All => all.Value;

        static readonly Lazy<ApiCatalog> oldest = new(() =>
        {
            UnityApiLists lists = UnityApiLists.Load();
            return new ApiCatalog(lists.WithOldestMathematics(), lists.Versions[0], only: ("Unity.Mathematics", UnityApiLists.OldestMathematics));
        });

        /// <summary>Versions that the package must compile with: every version, and the oldest with the lowest Unity.Mathematics that package.json
        /// lets a project have.</summary>
        public static IReadOnlyList<ApiCatalog> Supported => All.Append(oldest.Value).ToList();

        /// <param name="optional">Of packages that not every project has, or null.</param>
        public static IReadOnlyList<ApiCatalog> Make(UnityApiLists lists, UnityApiLists optional = null) =>
            lists.Versions.AsParallel().AsOrdered().Select(version => new ApiCatalog(lists, version, optional)).ToList();

        /// <summary>Lines that say nothing to the check, but for those known.</summary>
        public static IEnumerable<string> Unreadable(IEnumerable<ApiCatalog> catalogs) =>
            catalogs.SelectMany(catalog => catalog.Unreadable).Distinct().Where(line => !Garbled.Any(line.StartsWith));
    }
}
