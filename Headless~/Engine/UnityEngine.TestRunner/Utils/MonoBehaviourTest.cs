namespace UnityEngine.TestTools
{
    /// <summary>A test written as a component.</summary>
    public interface IMonoBehaviourTest { bool IsTestFinished { get; } }

    /// <summary>Waits until its component says that it is finished.</summary>
    public class MonoBehaviourTest<T> : CustomYieldInstruction where T : MonoBehaviour, IMonoBehaviourTest
    {
        public T component { get; }
        public GameObject gameObject => component.gameObject;
        public override bool keepWaiting => !component.IsTestFinished;

        public MonoBehaviourTest(bool dontDestroyOnLoad = true)
        {
            var host = new GameObject("MonoBehaviourTest: " + typeof(T).FullName);
            component = host.AddComponent<T>();
            if (dontDestroyOnLoad)
                Object.DontDestroyOnLoad(host);
        }
    }
}
