using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    public class YieldInstruction { }

    public sealed class Coroutine : YieldInstruction
    {
        // An enumerator that yields another one waits for it: the last is the one that runs.
        readonly Stack<IEnumerator> stack = new Stack<IEnumerator>();
        internal readonly MonoBehaviour Owner;
        internal readonly string MethodName;
        internal bool Done;
        internal CoroutinePoint ResumeAt;
        internal int NotBeforeFrame;
        double notBeforeTime;
        Coroutine awaited;
        AsyncOperation operation;

        internal Coroutine(MonoBehaviour owner, IEnumerator routine, string methodName)
        {
            Owner = owner;
            MethodName = methodName;
            stack.Push(routine);
        }

        internal bool Awaits(Coroutine other) => ReferenceEquals(awaited, other);
        internal bool Runs(IEnumerator routine) => stack.Contains(routine);

        internal bool IsDue
            => Time.frameCount >= NotBeforeFrame && Time.timeAsDouble >= notBeforeTime
            && (awaited == null || awaited.Done) && (operation == null || operation.isDone);

        /// <summary>Runs to the next yield; false when it has ended.</summary>
        internal bool Advance()
        {
            awaited = null;
            operation = null;
            notBeforeTime = double.NegativeInfinity;
            NotBeforeFrame = Time.frameCount + 1;
            ResumeAt = CoroutinePoint.Update;
            while (stack.Count > 0)
            {
                IEnumerator top = stack.Peek();
                bool more = top.MoveNext();
                // It may have stopped itself.
                if (Done)
                    return false;
                if (!more)
                {
                    stack.Pop();
                    continue;
                }
                switch (top.Current)
                {
                    case WaitForSeconds wait:
                        notBeforeTime = Time.timeAsDouble + wait.Seconds;
                        return true;
                    case WaitForFixedUpdate _:
                        NotBeforeFrame = 0;
                        ResumeAt = CoroutinePoint.FixedUpdate;
                        return true;
                    case WaitForEndOfFrame _:
                        NotBeforeFrame = CoroutineScheduler.At == CoroutinePoint.EndOfFrame ? Time.frameCount + 1 : 0;
                        ResumeAt = CoroutinePoint.EndOfFrame;
                        return true;
                    case Coroutine other:
                        awaited = other;
                        NotBeforeFrame = 0;
                        if (other.Done)
                            continue;
                        return true;
                    case AsyncOperation async:
                        operation = async;
                        if (async.isDone)
                            continue;
                        return true;
                    case IEnumerator inner:
                        stack.Push(inner);
                        continue;
                    default:
                        return true;
                }
            }
            return false;
        }

        /// <summary>finally blocks do not run, as Unity has it.</summary>
        internal void Drop() => stack.Clear();
    }

    public sealed class WaitForSeconds : YieldInstruction
    {
        internal readonly float Seconds;
        public WaitForSeconds(float seconds) { Seconds = seconds; }
    }

    public sealed class WaitForFixedUpdate : YieldInstruction { }
    public sealed class WaitForEndOfFrame : YieldInstruction { }

    public abstract class CustomYieldInstruction : IEnumerator
    {
        public abstract bool keepWaiting { get; }
        public object Current => null;
        public bool MoveNext() => keepWaiting;
        public virtual void Reset() { }
    }

    public sealed class WaitUntil : CustomYieldInstruction
    {
        readonly Func<bool> predicate;
        public WaitUntil(Func<bool> predicate) { this.predicate = predicate; }
        public override bool keepWaiting => !predicate();
    }

    public sealed class WaitWhile : CustomYieldInstruction
    {
        readonly Func<bool> predicate;
        public WaitWhile(Func<bool> predicate) { this.predicate = predicate; }
        public override bool keepWaiting => predicate();
    }

    public class WaitForSecondsRealtime : CustomYieldInstruction
    {
        double until = -1;

        public WaitForSecondsRealtime(float time) { waitTime = time; }
        public float waitTime { get; set; }

        public override bool keepWaiting
        {
            get
            {
                if (until < 0)
                    until = Time.realtimeSinceStartupAsDouble + waitTime;
                bool wait = Time.realtimeSinceStartupAsDouble < until;
                if (!wait)
                    Reset();
                return wait;
            }
        }

        public override void Reset() => until = -1;
    }
}
