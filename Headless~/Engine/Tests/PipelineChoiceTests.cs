using Host.Commands;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Choices of <c>rill run --pipeline</c>.</summary>
    public class PipelineChoiceTests
    {
        [TestCase("universal-14", "universal", "14", false)]
        [TestCase("universal-17", "universal", "17.0", false)]
        [TestCase("universal-17-compatibility", "universal", "17.0", true)]
        [TestCase("high-definition-14", "high-definition", "14", false)]
        [TestCase("high-definition-17", "high-definition", "17.0", false)]
        public void A_name_is_a_pipeline_a_version_and_a_path(string name, string kind, string version, bool byExecute)
        {
            PipelineChoice choice = PipelineChoice.Of(name);
            Assert.That(choice.Kind.Name, Is.EqualTo(kind));
            Assert.That(choice.Version.Name, Is.EqualTo(version));
            Assert.That(choice.ByExecute, Is.EqualTo(byExecute));
        }

        [Test]
        public void No_name_is_the_Built_in_pipeline() => Assert.That(PipelineChoice.Of(null), Is.Null);

        [TestCase("universal-13")]
        [TestCase("hdrp")]
        [TestCase("")]
        public void A_name_that_is_none_is_refused_with_those_that_are(string name) =>
            Assert.That(() => PipelineChoice.Of(name),
            Throws.TypeOf<HostException>().With.Message.EqualTo(
            $"--pipeline {name}: there are universal-14, universal-17, universal-17-compatibility, high-definition-14, high-definition-17."));

        [Test]
        public void A_project_of_its_own_is_drawn_by_the_Built_in_pipeline() =>
            Assert.That(() => PipelineChoice.Of("universal-17", "nowhere"),
            Throws.TypeOf<HostException>().With.Message.StartsWith("--pipeline plays scenes of this package; a project under --project"));
    }
}
