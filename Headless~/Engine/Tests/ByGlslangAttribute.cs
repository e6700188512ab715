using System;
using Host.Shaders;
using NUnit.Framework;
using NUnit.Framework.Interfaces;

namespace Host.Tests
{
    /// <summary>A test of what glslang makes of a text: it runs with glslang under --shaders fxc too, which the run reports.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class ByGlslangAttribute : Attribute, ITestAction
    {
        readonly string why;
        IShaderBackend before;

        public ByGlslangAttribute(string why) => this.why = why;

        public ActionTargets Targets => ActionTargets.Test;

        public void BeforeTest(ITest test)
        {
            before = ShaderBackend.Current;
            if (before == ShaderBackend.Glslang)
                return;
            ShaderBackend.Current = ShaderBackend.Glslang;
            ShaderBackend.Exempt($"{test.ClassName}.{test.MethodName}", why);
        }

        public void AfterTest(ITest test) => ShaderBackend.Current = before;
    }
}
