using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>In memory only: every run starts with none, so that runs are alike.</summary>
    public class PlayerPrefs
    {
        static readonly Dictionary<string, object> values = new Dictionary<string, object>();

        static PlayerPrefs() => PlayerLoop.ResetOthers += values.Clear;

        public static bool HasKey(string key) => values.ContainsKey(key);
        public static void DeleteKey(string key) => values.Remove(key);
        public static void DeleteAll() => values.Clear();
        public static void Save() { }
        public static void SetInt(string key, int value) => values[key] = value;
        public static void SetFloat(string key, float value) => values[key] = value;
        public static void SetString(string key, string value) => values[key] = value ?? "";
        public static int GetInt(string key) => GetInt(key, 0);
        public static float GetFloat(string key) => GetFloat(key, 0);
        public static string GetString(string key) => GetString(key, "");
        public static int GetInt(string key, int defaultValue) => Get(key, defaultValue);
        public static float GetFloat(string key, float defaultValue) => Get(key, defaultValue);
        public static string GetString(string key, string defaultValue) => Get(key, defaultValue);

        /// <summary>A value of another type counts as none.</summary>
        static T Get<T>(string key, T otherwise) => values.TryGetValue(key, out object found) && found is T value ? value : otherwise;
    }
}
