using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using Host.Check;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>The rule about what a reload of scripts carries over sees what is planted in this assembly, which stands here for a
    /// package's.</summary>
    public class CheckReloadFieldsTests
    {
        List<string> faults;

        [OneTimeSetUp]
        public void GiveOutThisAssemblyAsAPackage()
        {
            string folder = Path.Combine(Path.GetTempPath(), "rill-check-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
            try
            {
                File.Copy(typeof(CheckReloadFieldsTests).Assembly.Location, Path.Combine(folder, "Planted.dll"));
                File.WriteAllText(Path.Combine(folder, "Planted.asmdef"), "{ \"name\": \"Planted\" }");
                faults = new ReloadFieldsRule().Examine(new PackageTree(folder, folder)).Faults;
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        [TestCase("PlantedComponent.text")]
        [TestCase("PlantedComponent.numbers")]
        [TestCase("PlantedComponent.list")]
        [TestCase("PlantedComponent.counted")]
        [TestCase("PlantedComponent.reference")]
        [TestCase("PlantedComponent.curve")]
        [TestCase("PlantedComponent.state")]
        [TestCase("PlantedComponent+Setting.hidden")]
        [TestCase("PlantedComponent+Element.hidden")]
        [TestCase("PlantedBase`1[System.Int32].ofBase")]
        [TestCase("PlantedAsset.text")]
        [TestCase("PlantedWindow.text")]
        [TestCase("PlantedEditor.text")]
        public void A_private_field_that_a_reload_backs_up_is_named(string field)
            => Assert.That(faults, Has.Some.Match($"^{Regex.Escape("Host.Tests." + field)}\\b.* is backed up .*\\[NonSerialized\\]"));

        [Test]
        public void A_property_s_field_is_named_as_the_property()
            => Assert.That(faults, Has.Some.Contains("PlantedComponent.Shown ").And.Contains("[field: NonSerialized]"));

        [Test]
        public void What_is_a_setting_or_not_backed_up_is_no_fault()
            => Assert.That(faults, Has.None.Contains("PlantedFine"));
    }

    abstract class PlantedBase<T> : MonoBehaviour
    {
        T[] ofBase;
        protected T[] OfBase { get => ofBase; set => ofBase = value; }
    }

    sealed class PlantedComponent : PlantedBase<int>
    {
        [Serializable]
        class Setting
        {
            public float shown;
            string hidden;
            public string Hidden { get => hidden; set => hidden = value; }
        }

        [Serializable]
        struct Element
        {
            [SerializeField] int shown;
            int hidden;
            public int Sum { get => shown + hidden; set => hidden = value; }
        }

        [Serializable] struct State { public int value; }

        [SerializeField] Setting setting = new Setting();
        [SerializeField] List<Element> elements;
        string text;
        int[] numbers;
        List<Vector3> list;
        int counted;
        Transform reference;
        AnimationCurve curve;
        State state;

        public string Shown { get; private set; }

        void Use()
        {
            (text, numbers, list, counted, reference, curve) = (setting.Hidden, OfBase, null, elements[0].Sum, transform, null);
            state.value = counted;
            Shown = $"{text}{numbers}{list}{reference}{curve}{state.value}";
        }
    }

    sealed class PlantedAsset : ScriptableObject
    {
        string text;
        string Text { get => text; set => text = value; }
    }

    sealed class PlantedWindow : EditorWindow
    {
        string text;
        string Text { get => text; set => text = value; }
    }

    sealed class PlantedEditor : UnityEditor.Editor
    {
        string text;
        string Text { get => text; set => text = value; }
    }

    // Nothing of it is a fault.
    sealed class PlantedFine : MonoBehaviour
    {
        struct Unmarked { public int value; }
        sealed class UnmarkedClass { public int Value; }
        interface IAny { }

        public float setting;
        public string[] texts;
        [SerializeField] string marked;
        [SerializeReference] IAny any;
        [NonSerialized] string text;
        [NonSerialized] public string shown;
        readonly List<int> constant = new List<int>();
        Unmarked unmarked;
        UnmarkedClass unmarkedClass;
        UnmarkedClass[] unmarkedArray;
        Dictionary<string, int> dictionary;
        int[,] table;
        int[][] nested;
        Action callback;
        event Action Told;
        IAny unmarkedInterface;
        object anything;
        float? maybe;
        (int, int) pair;
        DateTime time;
        IntPtr handle;
        GraphicsBuffer buffer;
        MaterialPropertyBlock block;
        static string common;
        const int Limit = 3;

        [field: NonSerialized] public int Count { get; private set; }

        void Use()
        {
            (unmarkedClass, unmarkedArray, dictionary, table, nested, callback) = (new UnmarkedClass { Value = unmarked.value }, null, null, null,
                null, Told);
            (unmarkedInterface, anything, maybe, pair, time, handle, buffer, block) = (any, null, Limit, default, default, default, null, null);
            common = text + marked + $"{unmarkedClass}{unmarkedArray}{dictionary}{table}{nested}{callback}{unmarkedInterface}{anything}";
            Count = constant.Count + (maybe == null ? 0 : 1) + pair.Item1 + time.Day + handle.ToInt32() + (buffer == null ? 0 : 1);
            text = common + block;
            unmarked.value = Count;
        }
    }
}
