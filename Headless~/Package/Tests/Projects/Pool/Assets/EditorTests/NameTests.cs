using NUnit.Framework;
using UnityEditor;

public class NameTests
{
    [Test]
    public void Names_of_fields_are_shown_as_words() => Assert.That(ObjectNames.NicifyVariableName("restDensity"), Is.EqualTo("Rest Density"));
}
