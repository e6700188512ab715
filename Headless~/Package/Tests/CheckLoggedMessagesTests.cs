using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about logged messages names those that no page of the manual has, from wherever their text comes.</summary>
    public class CheckLoggedMessagesTests
    {
        const string Logged = "class A { void B() => Debug.LogWarning($\"Rill: A '{name}' leaks a little water: \" + why); }";

        static string[] Faults(string code, string page, string file = "Runtime/A.cs", string manual = "Documentation~/page.md")
        {
            using var package = new SyntheticPackage();
            return new LoggedMessagesRule().Examine(package.Add(file, "// first\n" + code).Add(manual, page).Tree).Faults.ToArray();
        }

        static string[] Stems(string code) => LoggedMessages.Of(new[] { ("A.cs", code) }).Select(message => message.Stem).ToArray();

        [TestCase("| A ... leaks a little water: ... | close it |")]
        [TestCase("It *leaks a little\n`water`*.")]
        public void A_message_on_a_page_is_no_fault(string page) => Assert.That(Faults(Logged, page), Is.Empty);

        [TestCase("")]
        [TestCase("It leaks a little wine.")]
        [TestCase("It leaks a little waterfall.")]
        public void One_that_no_page_has_is_named_with_its_line(string page) => Assert.That(Faults(Logged, page), Has.Length.EqualTo(1)
            .And.All.Contains("Runtime/A.cs(2) logs \"leaks a little water ...\""));

        // What is inserted may complete a word: a page has the whole word, a message's text only a part of it.
        [TestCase("lighter than a 1/{ratio} of it", "It is lighter than a 1/1000 of it.")]
        [TestCase("a {word}able part of it", "It is a washable part of it.")]
        public void A_word_that_is_partly_inserted_is_not_compared(string text, string page)
            => Assert.That(Faults($"class A {{ void B() => Debug.Log($\"{text}\"); }}", page), Is.Empty);

        [TestCase("lighter than {ratio} of all that is here", "lighter than")]
        [TestCase("'{name}', which is light, has '{other}'", "which is light has")]
        public void A_word_beside_an_inserted_one_is_compared(string text, string words)
            => Assert.That(Stems($"class A {{ void B() => Debug.Log($\"a {text}\"); }}"), Has.Some.Contains(words));

        [Test]
        public void A_page_of_the_research_does_not_count()
            => Assert.That(Faults(Logged, "It leaks a little water.", manual: "Research~/page.md"), Has.Length.EqualTo(1));

        [TestCase("Tests/A.cs")]
        [TestCase("Headless~/A.cs")]
        public void Code_that_users_do_not_run_need_not_be_in_the_manual(string file)
            => Assert.That(Faults(Logged, "", file), Has.Length.EqualTo(1).And.All.Contains("no message is logged"));

        [TestCase("void B() => Debug.LogError(\"Rill: it leaks \" + \"a little water\", this);")]
        [TestCase("void B() => Debug.Log(Invariant($\"Rill: {count} of it leaks a little water\"));")]
        [TestCase("void B() => Warn(\"it leaks a little water\"); void Warn(string problem) => Debug.LogWarning($\"Rill: {problem}\", this);")]
        [TestCase("void B() => C(\"it leaks a little water\"); void C(string what) => D(what); void D(string what) => Debug.Log(what);")]
        [TestCase("void B() => Debug.LogError($\"{name} {Problem}\"); string Problem => \"it leaks a little water\";")]
        [TestCase("void B() => Debug.LogError(Problem()); string Problem() { return \"it leaks a little water\"; }")]
        [TestCase("void B() => Debug.LogError(A.Problem); const string Problem = \"it leaks a little water\";")]
        [TestCase("void B() => Debug.LogError(is ? \"it leaks a little water\" : \"no\");")]
        [TestCase("void B() => Debug.LogError(kind switch { 1 => \"it leaks a little water\", _ => name });")]
        [TestCase("void B() { string problem = null; if (is) problem = \"it leaks a little water\"; Debug.LogError(problem ?? name); }")]
        public void Its_text_is_found_wherever_it_comes_from(string members)
            => Assert.That(Stems($"class A {{ {members} }}"), Has.Some.EndWith("it leaks a little water").Or.Some.EqualTo("of it leaks a little"));

        [TestCase("void B() => Debug.LogException(problem, this);")]
        [TestCase("void B() => Debug.Log($\"Rill: {name} is off\");")]
        [TestCase("void B() => Show(\"it leaks a little water\");")]
        [TestCase("void B(string problem) => Throw(problem); void C() => B(\"it leaks a little water\");")]
        public void What_is_not_logged_or_has_no_words_of_its_own_is_left_out(string members)
            => Assert.That(Stems($"class A {{ {members} }}"), Is.Empty);

        [Test]
        public void The_same_words_count_once()
            => Assert.That(Stems("class A { void B() { Debug.Log(\"it leaks a little\"); Debug.LogError(\"it leaks a little\"); } }"),
                Has.Length.EqualTo(1));
    }
}
