using Host.Commands;
using Host.Shaders;
using NUnit.Framework;

namespace Host.Tests
{
    public class ShadersOptionTests
    {
        IShaderBackend before;

        [SetUp]
        public void Keep() => before = ShaderBackend.Current;

        [TearDown]
        public void Restore() => ShaderBackend.Current = before;

        [TestCase("glslang")]
        [TestCase("fxc")]
        public void A_compiler_is_chosen_by_its_name(string name)
        {
            ShadersOption.Use(name);
            Assert.That(ShaderBackend.Current.Name, Is.EqualTo(name));
        }

        [Test]
        public void Another_name_is_refused_with_those_that_there_are()
            => Assert.That(Assert.Throws<HostException>(() => ShadersOption.Use("dxc")).Message,
                Is.EqualTo("--shaders dxc: there are glslang and fxc."));
    }
}
