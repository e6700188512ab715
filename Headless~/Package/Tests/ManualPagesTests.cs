using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Rill;
using UnityEditor;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>That a component is found in the menu, has an icon, and opens its section of the manual.</summary>
    public class ManualPagesTests
    {
        static IEnumerable<Type> Components()
            => new[] { "Rill", "Rill.Physics", "Rill.Terrain" }.SelectMany(name => Assembly.Load(name).GetTypes())
                .Where(type => typeof(MonoBehaviour).IsAssignableFrom(type) && type.IsPublic && !type.IsAbstract)
                .Concat(new[] { typeof(SignedDistanceField), typeof(FluidSnapshotAsset), typeof(FluidMaterialAsset), typeof(FluidPreset) });

        [TestCaseSource(nameof(Components))]
        public void A_component_or_asset_has_an_icon_and_opens_its_section(Type type)
        {
            if (typeof(MonoBehaviour).IsAssignableFrom(type))
                Assert.That(type.GetCustomAttribute<AddComponentMenu>().componentMenu, Does.StartWith("Rill/"));
            Assert.That(type.GetCustomAttribute<IconAttribute>()?.path, Is.EqualTo(PackagePaths.Icon));
            Assert.That(File.Exists(InPackage(PackagePaths.Icon)));
            var help = (ManualPageAttribute)type.GetCustomAttribute<HelpURLAttribute>();
            Assert.That(help, Is.Not.Null);
            string page = File.ReadAllText(InPackage(PackagePaths.Manual + help.Page + ".md"));
            Assert.That(page, Does.Contain(ObjectNames.NicifyVariableName(type.Name)).Or.Contain(type.Name));
            // Here a folder of the one that the test runs in; the editor finds the package's.
            string file = "html/help/" + help.Page + "." + help.Section + ".html";
            Assert.That(help.URL, Does.StartWith("file:///").And.EndWith("/Packages/com.rill.fluids/Documentation~/" + file));
            Assert.That(File.ReadAllText(InPackage(PackagePaths.Manual + file)),
                Does.Contain("content=\"0; url=../" + help.Page + ".html#" + help.Section + "\""));
            Assert.That(File.ReadAllText(InPackage(PackagePaths.Manual + "html/" + help.Page + ".html")),
                Does.Contain("id=\"" + help.Section + "\""));
        }

        static string InPackage(string path) => Path.Combine(PackageFolder.Path, path.Substring(PackagePaths.Root.Length));
    }
}
