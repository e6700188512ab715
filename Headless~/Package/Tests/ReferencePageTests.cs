using System;
using System.IO;
using System.Linq;
using Host.Check;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>The manual's page of fields against components whose fields are known.</summary>
    public sealed class ReferencePageTests : EngineFixture
    {
        [Serializable]
        struct Group
        {
            [Tooltip("How much, m.")] [Min(0.5f)] public float amount;
            [NonSerialized] public int hidden;
        }

        enum Choice { FirstOne, Second }

        class Base : MonoBehaviour
        {
            [Tooltip("From the base class.")]
            [SerializeField] protected bool isOn = true;
        }

        [AddComponentMenu("Planted/Known Part")]
        sealed class Known : Base
        {
            [Tooltip("Between two | bars.")]
            [UnityEngine.Range(0f, 1e-6f)]
            [SerializeField] float smallValue = 5e-7f;
            [SerializeField] Choice choice = Choice.Second;
            [SerializeField] Vector3 size = new Vector3(1f, 2.5f, 0f);
            [SerializeField] Group settings = new Group { amount = 2f };
            [SerializeField] Transform target;
            [SerializeField, HideInInspector] int unseen = 1;
            int notStored = 2;

            public int Unused => unseen + notStored + (target != null ? (int)size.x : (int)smallValue) + (int)choice + (int)settings.amount;
        }

        [Test]
        public void Each_stored_field_has_its_default_range_and_tooltip()
        {
            Assert.That(ReferencePage.Describe(typeof(Known)),
                Is.EqualTo("\n## Known Part\n\n| field | default | range | |\n| --- | --- | --- | --- |\n" +
                "| Choice | Second | First One, Second |  |\n" +
                "| Is On | on |  | From the base class. |\n" +
                "| Size | 1, 2.5, 0 |  |  |\n" +
                "| Small Value | 0.0000005 | 0 to 0.000001 | Between two \\| bars. |\n" +
                "| Target | none |  |  |\n" +
                "\n**Settings**\n\n| field | default | range | |\n| --- | --- | --- | --- |\n" +
                "| Amount | 2 | 0.5 or more | How much, m. |\n"));
        }

        [Serializable]
        struct Pair
        {
            [Tooltip("The one.")] public Group first;
            [Tooltip("The other.")] public Group second;
        }

        [AddComponentMenu("Planted/Nested Part")]
        sealed class Nested : MonoBehaviour
        {
            [SerializeField] Pair both = new Pair { first = new Group { amount = 3f } };

            public int Unused => (int)both.first.amount;
        }

        [Test]
        public void Groups_within_a_group_have_one_table_of_their_fields()
        {
            Assert.That(ReferencePage.Describe(typeof(Nested)), Does.Contain("\n**Both**\n").And.Contain("|  | The other. |\n").And.EndWith(
                "\n**Group**\n\n| field | default | range | |\n| --- | --- | --- | --- |\n| Amount | 3 | 0.5 or more | How much, m. |\n"));
        }

        [Test]
        public void Costs_stand_beside_their_fields_and_rows_of_no_field_are_faults()
        {
            var findings = new Findings();
            var costs = FieldCosts.Of("# a remark\nKnown Part\t\ttwo passes\nKnown Part\tAmount\t1 ms\nKnown Part\tGone\t2 ms\nno row\n" +
                "Known Part\tAmount\t3 ms\n", findings);
            string text = ReferencePage.Describe(typeof(Known), costs);
            costs.FindUnused(findings);
            Assert.That(text, Does.StartWith("\n## Known Part\n\nCost: two passes.\n\n| field | default | range | | cost |\n").And
                .Contain("| Amount | 2 | 0.5 or more | How much, m. | 1 ms |\n").And.Contain("| Is On | on |  | From the base class. |  |\n"));
            Assert.That(findings.Faults, Is.EqualTo(new[]
            {
                "Research~/data/costs.tsv(5) is not a new row: write component, field and cost, with a tab between, each once.",
                "Research~/data/costs.tsv(6) is not a new row: write component, field and cost, with a tab between, each once.",
                "Research~/data/costs.tsv: no component 'Known Part' has a field 'Gone'. Write its name as the inspector shows it.",
            }));
        }

        [Test]
        public void The_page_in_the_manual_is_what_the_components_say()
        {
            var findings = new Findings();
            string text = new ReferencePage().Text(new PackageTree(Session.Root()), findings);
            Assert.That(findings.Faults, Is.Empty);
            Assert.That(text, Does.Contain("\n## Fluid Simulation\n").And.Contain("\n## Fluid Buoyancy\n").And.Contain(
                "\n| Particle Spacing | 0.05 |"));
            Assert.That(File.ReadAllText(Path.Combine(Session.Root(), "Documentation~", "reference.md")).Replace("\r\n", "\n"), Is.EqualTo(text));
        }
    }
}
