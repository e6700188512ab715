using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools
{
    /// <summary>Skips a test on platforms that are not included, or are excluded.</summary>
    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method, AllowMultiple = true)]
    public class UnityPlatformAttribute : NUnitAttribute, IApplyToTest
    {
        public RuntimePlatform[] include { get; set; } = Array.Empty<RuntimePlatform>();
        public RuntimePlatform[] exclude { get; set; } = Array.Empty<RuntimePlatform>();

        public UnityPlatformAttribute() { }
        public UnityPlatformAttribute(params RuntimePlatform[] include) => this.include = include;

        public void ApplyToTest(Test test)
        {
            RuntimePlatform here = Application.platform;
            bool wanted = include.Length == 0 || include.Contains(here);
            if (test.RunState == RunState.NotRunnable || test.RunState == RunState.Ignored || (wanted && !exclude.Contains(here)))
                return;
            test.RunState = RunState.Skipped;
            test.Properties.Set(PropertyNames.SkipReason, wanted ? $"Not supported on {here}" : $"Only supported on {string.Join(", ", include)}");
        }
    }

    /// <summary>Ignores a test when the condition of that name was set.</summary>
    [AttributeUsage(AttributeTargets.Method | AttributeTargets.Class | AttributeTargets.Assembly)]
    public class ConditionalIgnoreAttribute : NUnitAttribute, IApplyToTest
    {
        static readonly Dictionary<string, bool> conditions = new Dictionary<string, bool>();
        readonly string condition, reason;

        public ConditionalIgnoreAttribute(string conditionKey, string ignoreReason) { condition = conditionKey; reason = ignoreReason; }

        public static void AddConditionalIgnoreMapping(string key, bool value) => conditions.Add(key, value);

        public void ApplyToTest(Test test)
        {
            if (test.RunState == RunState.NotRunnable || !conditions.TryGetValue(condition, out bool ignore) || !ignore)
                return;
            test.RunState = RunState.Ignored;
            test.Properties.Set(PropertyNames.SkipReason, $"ConditionalIgnore set to {condition}. {reason}".TrimEnd());
        }
    }
}
