using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Host.Check
{
    /// <summary>One text that the code logs, with the words by which it is known.</summary>
    readonly struct LoggedMessage
    {
        public readonly string File, Stem;
        public readonly int Line;

        public LoggedMessage(string file, int line, string stem) => (File, Line, Stem) = (file, line, stem);
    }

    /// <summary>Finds the texts that calls of Debug.Log and its kin get: directly, through methods that pass a text on, and from members, locals
    /// and branches that a text is made of. Syntax alone decides, so a text of an exception or of a member of a base class is not found.</summary>
    sealed class LoggedMessages
    {
        const int StemWords = 5, FewestWords = 3, NameWords = 1, IntroductionWords = 6;
        const char Hole = '\uFFFC';        // at both ends of what is inserted
        static readonly Regex Word = new(@"[\p{L}\p{N}][\p{L}\p{N}'.,/-]*"), SentenceEnd = new(@"\.\s");
        // Words of which only a part is written, as the 1/ of 1/{ratio}.
        static readonly Regex Fragment = new($"{Word}{Hole}|{Hole}{Word}");

        readonly Dictionary<string, SyntaxNode> files;
        readonly ILookup<string, string> filesOfTypes;
        readonly HashSet<string> loggers = new();
        readonly HashSet<SyntaxNode> seen = new();
        readonly List<LoggedMessage> messages = new();

        LoggedMessages(IEnumerable<(string file, string text)> sources)
        {
            files = sources.ToDictionary(source => source.file, source => CSharpSyntaxTree.ParseText(source.text).GetRoot());
            filesOfTypes = files.SelectMany(file => file.Value.DescendantNodes(IsAroundTypes).OfType<TypeDeclarationSyntax>(),
                (file, type) => (file.Key, type.Identifier.Text)).Distinct().ToLookup(pair => pair.Text, pair => pair.Key);
        }

        static bool IsAroundTypes(SyntaxNode node) => node is CompilationUnitSyntax or BaseNamespaceDeclarationSyntax or TypeDeclarationSyntax;

        /// <summary>The messages of these files, those with the same stem once.</summary>
        public static List<LoggedMessage> Of(IEnumerable<(string file, string text)> sources)
        {
            var found = new LoggedMessages(sources);
            found.FindLoggers();
            foreach ((string file, SyntaxNode root) in found.files)
                foreach (InvocationExpressionSyntax call in root.DescendantNodes().OfType<InvocationExpressionSyntax>())
                    if (found.IsLogger(call) && call.ArgumentList.Arguments.Count > 0)
                        found.Follow(file, call.ArgumentList.Arguments[0].Expression);
            return found.messages.GroupBy(message => message.Stem).Select(same => same.First()).ToList();
        }

        /// <summary>A text as it is compared: its words in lower case, one space apart.</summary>
        public static string Normalize(string text)
            => " " + string.Join(' ', Words(text)) + " ";

        static string[] Words(string text)
            => Word.Matches(text.ToLowerInvariant()).Select(match => match.Value.TrimEnd('.', ',', '-', '/', '\'')).ToArray();

        static bool IsUnityLog(InvocationExpressionSyntax call)
            => call.Expression is MemberAccessExpressionSyntax { Expression: IdentifierNameSyntax { Identifier.Text: "Debug" } } access
            && access.Name.Identifier.Text is "Log" or "LogWarning" or "LogError";

        bool IsLogger(InvocationExpressionSyntax call) => IsUnityLog(call) || call.Expression is IdentifierNameSyntax name
            && loggers.Contains(name.Identifier.Text);

        // A method whose first parameter is in the text of a log, in as many steps as there are.
        void FindLoggers()
        {
            var takers = new List<(string method, string parameter, List<InvocationExpressionSyntax> calls)>();
            foreach (MethodDeclarationSyntax method in files.Values.SelectMany(root => root.DescendantNodes()).OfType<MethodDeclarationSyntax>())
                if (method.ParameterList.Parameters.FirstOrDefault() is { Type: { } type } first && type.ToString() == "string")
                    takers.Add((method.Identifier.Text, first.Identifier.Text, method.DescendantNodes().OfType<InvocationExpressionSyntax>()
                        .Where(call => Names(call, first.Identifier.Text)).ToList()));
            int before;
            do
            {
                before = loggers.Count;
                loggers.UnionWith(takers.Where(taker => taker.calls.Any(IsLogger)).Select(taker => taker.method).ToList());
            }
            while (loggers.Count > before);
        }

        static bool Names(InvocationExpressionSyntax call, string parameter) => call.ArgumentList.Arguments.Count > 0
            && call.ArgumentList.Arguments[0].DescendantNodes().OfType<IdentifierNameSyntax>().Any(name => name.Identifier.Text == parameter);

        void Follow(string file, ExpressionSyntax text)
        {
            if (!seen.Add(text))
                return;
            var pieces = new List<StringBuilder> { new() };
            var holes = new List<ExpressionSyntax>();
            Gather(text, pieces, holes);
            List<string[]> sentences = pieces.Select(piece => Fragment.Replace(piece.ToString(), " ").Replace("Rill:", ""))
                .SelectMany(piece => SentenceEnd.Split(piece)).Select(Words).ToList();
            string[] stem = sentences.FirstOrDefault(words => words.Length >= FewestWords);
            if (stem != null)
                messages.Add(new LoggedMessage(file, text.GetLocation().GetLineSpan().StartLinePosition.Line + 1,
                    string.Join(' ', stem.Take(StemWords))));
            int before = 0, all = pieces.Sum(piece => Words(piece.ToString()).Length);
            for (int i = 0; i < holes.Count; i++)
            {
                before += Words(pieces[i].ToString()).Length;
                // The text that a message begins with, or ends with after few words; others fill in a name, a remedy or a number.
                if (before <= NameWords || before == all && before <= IntroductionWords)
                    foreach ((string from, ExpressionSyntax value) in Values(file, holes[i]).ToList())
                        Follow(from, value);
            }
        }

        // Appends constant text to the last piece; what is not constant is a hole, after which another begins.
        static void Gather(ExpressionSyntax text, List<StringBuilder> pieces, List<ExpressionSyntax> holes)
        {
            switch (text)
            {
                case LiteralExpressionSyntax literal when literal.IsKind(SyntaxKind.StringLiteralExpression):
                    pieces[^1].Append(literal.Token.ValueText);
                    return;
                case InterpolatedStringExpressionSyntax interpolated:
                    foreach (InterpolatedStringContentSyntax content in interpolated.Contents)
                        if (content is InterpolatedStringTextSyntax constant)
                            pieces[^1].Append(constant.TextToken.ValueText);
                        else
                            Gather(((InterpolationSyntax)content).Expression, pieces, holes);
                    return;
                case BinaryExpressionSyntax sum when sum.IsKind(SyntaxKind.AddExpression):
                    Gather(sum.Left, pieces, holes);
                    Gather(sum.Right, pieces, holes);
                    return;
                case ParenthesizedExpressionSyntax inner:
                    Gather(inner.Expression, pieces, holes);
                    return;
                case InvocationExpressionSyntax { Expression: IdentifierNameSyntax { Identifier.Text: "Invariant" } } invariant:
                    Gather(invariant.ArgumentList.Arguments[0].Expression, pieces, holes);
                    return;
                default:
                    holes.Add(text);
                    pieces[^1].Append(Hole);
                    pieces.Add(new StringBuilder().Append(Hole));
                    return;
            }
        }

        // The expressions of which a value is one.
        IEnumerable<(string file, ExpressionSyntax text)> Values(string file, ExpressionSyntax value) => value switch
        {
            ParenthesizedExpressionSyntax inner => Values(file, inner.Expression),
            PostfixUnaryExpressionSyntax forgiven => Values(file, forgiven.Operand),
            ConditionalExpressionSyntax choice => new[] { (file, choice.WhenTrue), (file, choice.WhenFalse) },
            BinaryExpressionSyntax either when either.IsKind(SyntaxKind.CoalesceExpression) => new[] { (file, either.Left), (file, either.Right) },
            SwitchExpressionSyntax choice => choice.Arms.Select(arm => (file, arm.Expression)),
            IdentifierNameSyntax name => Locals(name).Select(local => (file, local)).Concat(Members(file, name.Identifier.Text)),
            InvocationExpressionSyntax { Expression: IdentifierNameSyntax method } => Members(file, method.Identifier.Text),
            InvocationExpressionSyntax { Expression: MemberAccessExpressionSyntax access } => OfType(access),
            MemberAccessExpressionSyntax access => OfType(access),
            _ => Enumerable.Empty<(string, ExpressionSyntax)>(),
        };

        // Texts that the method around a name gives to the local or out parameter of that name.
        static IEnumerable<ExpressionSyntax> Locals(IdentifierNameSyntax name)
        {
            SyntaxNode method = name.Ancestors().FirstOrDefault(node => node is BaseMethodDeclarationSyntax or AccessorDeclarationSyntax
                or PropertyDeclarationSyntax);
            if (method == null)
                yield break;
            foreach (SyntaxNode node in method.DescendantNodes())
                if (node is VariableDeclaratorSyntax { Initializer: { } set } variable && variable.Identifier.Text == name.Identifier.Text)
                    yield return set.Value;
                else if (node is AssignmentExpressionSyntax { Left: IdentifierNameSyntax left } assignment
                    && left.Identifier.Text == name.Identifier.Text)
                    yield return assignment.Right;
        }

        // Texts of the members of that name in a file: what a property or method returns, and what a field or constant is set to.
        IEnumerable<(string, ExpressionSyntax)> Members(string file, string name)
        {
            foreach (SyntaxNode node in files[file].DescendantNodes())
                switch (node)
                {
                    case PropertyDeclarationSyntax property when property.Identifier.Text == name && property.Type.ToString() == "string":
                    case MethodDeclarationSyntax method when method.Identifier.Text == name && method.ReturnType.ToString() == "string":
                        foreach (ExpressionSyntax text in Returned(node))
                            yield return (file, text);
                        break;
                    case VariableDeclaratorSyntax { Initializer: { } set, Parent.Parent: FieldDeclarationSyntax } field
                        when field.Identifier.Text == name:
                        yield return (file, set.Value);
                        break;
                    case AssignmentExpressionSyntax { Left: IdentifierNameSyntax left } assignment when left.Identifier.Text == name
                        && char.IsUpper(name[0]):
                        yield return (file, assignment.Right);
                        break;
                }
        }

        IEnumerable<(string, ExpressionSyntax)> OfType(MemberAccessExpressionSyntax access)
            => access.Expression is not IdentifierNameSyntax type ? Enumerable.Empty<(string, ExpressionSyntax)>()
            : filesOfTypes[type.Identifier.Text].SelectMany(file => Members(file, access.Name.Identifier.Text));

        static IEnumerable<ExpressionSyntax> Returned(SyntaxNode member)
            => member.DescendantNodes().Select(node => node switch
            {
                ArrowExpressionClauseSyntax arrow => arrow.Expression,
                ReturnStatementSyntax answer => answer.Expression,
                _ => null,
            }).Where(text => text != null);
    }
}
