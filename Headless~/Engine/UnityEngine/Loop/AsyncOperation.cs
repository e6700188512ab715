using System;

namespace UnityEngine
{
    public class AsyncOperation : YieldInstruction
    {
        Action<AsyncOperation> whenCompleted;
        bool done;

        public bool isDone => done;
        public float progress => done ? 1 : 0;
        public int priority { get; set; }
        public bool allowSceneActivation { get; set; } = true;

        /// <summary>A handler that comes too late is called at once.</summary>
        public event Action<AsyncOperation> completed
        {
            add
            {
                if (done) value(this);
                else whenCompleted += value;
            }
            remove => whenCompleted -= value;
        }

        internal void Complete()
        {
            done = true;
            Action<AsyncOperation> handlers = whenCompleted;
            whenCompleted = null;
            handlers?.Invoke(this);
        }
    }

    public class ResourceRequest : AsyncOperation
    {
        internal Object Loaded;
        public Object asset => GetResult();
        protected virtual Object GetResult() => Loaded;
    }
}
