using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Headless;

namespace Host.Tests
{
    public class EngineEventTests
    {
        [Serializable] class FloatEvent : UnityEvent<float> { }

        class Listener : MonoBehaviour
        {
            public UnityEvent plain = new UnityEvent();
            public readonly List<string> heard = new List<string>();
            public void Nothing() => heard.Add("nothing");
            public void Number(float value) => heard.Add("number " + value);
            public void Text(string value) => heard.Add("text " + value);
        }

        GameObject owner;

        [SetUp]
        public void MakeOwner() => owner = new GameObject("owner");

        [TearDown]
        public void DestroyOwner() => UnityEngine.Object.DestroyImmediate(owner);

        [Test]
        public void Listeners_are_called_in_their_order_until_they_are_removed()
        {
            var heard = new List<string>();
            var changed = new FloatEvent();
            UnityAction<float> first = value => heard.Add("first " + value);
            changed.AddListener(first);
            changed.AddListener(value => heard.Add("second " + value));
            changed.Invoke(1);
            changed.RemoveListener(first);
            changed.Invoke(2);
            changed.RemoveAllListeners();
            changed.Invoke(3);
            Assert.That(heard, Is.EqualTo(new[] { "first 1", "second 1", "second 2" }));
        }

        [Test]
        public void A_listener_that_throws_throws_out_of_Invoke_by_itself()
        {
            var happened = new UnityEvent();
            happened.AddListener(() => throw new InvalidOperationException("planted"));
            Assert.That(Assert.Throws<InvalidOperationException>(() => happened.Invoke()).Message, Is.EqualTo("planted"));
        }

        [Test]
        public void The_listener_of_a_destroyed_object_is_passed_over()
        {
            var listener = owner.AddComponent<Listener>();
            var happened = new UnityEvent();
            happened.AddListener(listener.Nothing);
            UnityEngine.Object.DestroyImmediate(listener);
            happened.Invoke();
            Assert.That(listener.heard, Is.Empty);
        }

        [Test]
        public void Stored_listeners_come_first_with_their_stored_argument_and_a_copy_calls_the_copy()
        {
            var listener = owner.AddComponent<Listener>();
            Store(listener.plain, listener, nameof(Listener.Text), PersistentListenerMode.String,
                new PersistentArguments { m_StringArgument = "stored" });
            Store(listener.plain, listener, nameof(Listener.Number), PersistentListenerMode.Float,
                new PersistentArguments { m_FloatArgument = 2.5f });
            listener.plain.AddListener(listener.Nothing);
            listener.plain.Invoke();
            Assert.That(listener.heard, Is.EqualTo(new[] { "text stored", "number 2.5", "nothing" }));
            Assert.That(listener.plain.GetPersistentEventCount(), Is.EqualTo(2));
            Assert.That(listener.plain.GetPersistentMethodName(1), Is.EqualTo("Number"));

            GameObject copy = UnityEngine.Object.Instantiate(owner);
            var copied = copy.GetComponent<Listener>();
            copied.plain.SetPersistentListenerState(1, UnityEventCallState.Off);
            copied.plain.Invoke();
            Assert.That(copied.heard, Is.EqualTo(new[] { "text stored" }), "what scripts added is not copied, what is off is not called");
            Assert.That(listener.heard.Count, Is.EqualTo(3));
            UnityEngine.Object.DestroyImmediate(copy);
        }

        [Test]
        public void A_stored_method_that_is_gone_is_named()
        {
            var listener = owner.AddComponent<Listener>();
            Store(listener.plain, listener, "Gone", PersistentListenerMode.Void, new PersistentArguments());
            var logged = new List<string>();
            Action<LogEntry> hear = entry => logged.Add(entry.ToString());
            LogSink.Received += hear;
            listener.plain.Invoke();
            LogSink.Received -= hear;
            Assert.That(logged, Is.EqualTo(new[] { "Warning: UnityEvent: 'owner' (Listener) has no method Gone(), so this listener is not called" }));
        }

        static void Store(UnityEventBase owner, UnityEngine.Object target, string method, PersistentListenerMode mode, PersistentArguments arguments)
        {
            var field = typeof(UnityEventBase).GetField("m_PersistentCalls",
                System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic);
            ((PersistentCalls)field.GetValue(owner)).m_Calls.Add(new PersistentCall { m_Target = target, m_MethodName = method,
                m_Mode = mode, m_Arguments = arguments });
        }
    }
}
