using System.Collections.Generic;
using System.Linq;
using Host.Shaders;

namespace Host.Testing
{
    /// <summary>Facts that a process knows when its tests are done. It goes from a worker to its parent as JSON.</summary>
    sealed class TestFacts
    {
        public string Device { get; set; }
        public List<string> ValidationMessages { get; set; } = new();

        /// <summary>Objects that outlived the tests, each with who made it.</summary>
        public List<string> Left { get; set; } = new();

        public Dictionary<string, string> Programs { get; set; } = new();
        public Dictionary<string, string> ExemptTests { get; set; } = new();

        /// <summary>Ends the session.</summary>
        public static TestFacts Of(Session session, TestRun run)
        {
            List<string> left = run.NameLeft(session.End()).ToList();
            (Dictionary<string, string> programs, Dictionary<string, string> exempt) = ShaderBackend.Tallies();
            return new TestFacts { Device = session.DescribeDevice(), Left = left, ValidationMessages = session.ValidationMessages.ToList(),
                Programs = programs, ExemptTests = exempt };
        }
    }
}
