using NUnit.Framework;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Variants of the shaders that draw the surface's mesh.</summary>
    public class MeshDrawTests
    {
        // Each setting is turned off while the others are on, and then all are.
        [Test]
        public void A_setting_that_is_turned_off_leaves_no_keyword_on()
        {
            const string refraction = "RILL_REFRACTION", reflection = "RILL_OWN_REFLECTION", foam = "RILL_FOAM";
            var colors = new Material(StageShader.Load("Water").Shader);
            try
            {
                using (var draw = new MeshDraw(colors))
                {
                    Assert.That(colors.shaderKeywords, Is.Empty);
                    draw.SetKeywords(true, true, true);
                    Assert.That(colors.shaderKeywords, Is.EquivalentTo(new[] { refraction, reflection, foam }));
                    draw.SetKeywords(false, true, true);
                    Assert.That(colors.shaderKeywords, Is.EquivalentTo(new[] { reflection, foam }));
                    draw.SetKeywords(true, false, true);
                    Assert.That(colors.shaderKeywords, Is.EquivalentTo(new[] { refraction, foam }));
                    draw.SetKeywords(true, true, false);
                    Assert.That(colors.shaderKeywords, Is.EquivalentTo(new[] { refraction, reflection }));
                    draw.SetKeywords(false, false, false);
                    Assert.That(colors.shaderKeywords, Is.Empty);
                }
            }
            finally
            {
                Object.DestroyImmediate(colors);
            }
        }
    }
}
