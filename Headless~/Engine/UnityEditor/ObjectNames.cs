using System.Text;

namespace UnityEditor
{
    public sealed class ObjectNames
    {
        /// <summary>"m_maxSteps" and "maxSteps" become "Max Steps".</summary>
        public static string NicifyVariableName(string name)
        {
            int start = name.StartsWith("m_", System.StringComparison.Ordinal) ? 2 : 0;
            if (start == 0 && name.Length > 1 && name[0] == 'k' && char.IsUpper(name[1]))
                start = 1;
            while (start < name.Length && name[start] == '_')
                start++;
            var text = new StringBuilder();
            for (int i = start; i < name.Length; i++)
            {
                char c = name[i];
                bool begins = char.IsUpper(c) && i > start && (!char.IsUpper(name[i - 1]) || i + 1 < name.Length && char.IsLower(name[i + 1]));
                bool number = char.IsDigit(c) && i > start && !char.IsDigit(name[i - 1]);
                if (begins || number)
                    text.Append(' ');
                text.Append(i == start ? char.ToUpperInvariant(c) : c);
            }
            return text.ToString();
        }
    }
}
