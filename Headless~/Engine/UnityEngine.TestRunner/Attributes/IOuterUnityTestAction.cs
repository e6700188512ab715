using System.Collections;
using NUnit.Framework.Interfaces;

namespace UnityEngine.TestTools
{
    /// <summary>Work around a test and its set-up, as an attribute on the test.</summary>
    public interface IOuterUnityTestAction
    {
        IEnumerator BeforeTest(ITest test);
        IEnumerator AfterTest(ITest test);
    }
}
