using System;
using System.Collections;
using System.Diagnostics;
using System.Reflection;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using UnityEngine.TestTools;

namespace UnityEngine.Headless
{
    /// <summary>A test method as NUnit sees it, played like in Unity: coroutines over frames, the log watched, [UnitySetUp] around it.</summary>
    internal sealed class PlayedMethod : IMethodInfo
    {
        readonly IMethodInfo method;

        public PlayedMethod(IMethodInfo method) => this.method = method;

        /// <summary>Makes every test below a node a played one.</summary>
        public static void ApplyTo(ITest test)
        {
            if (test is TestMethod leaf && !(leaf.Method is PlayedMethod))
                leaf.Method = new PlayedMethod(leaf.Method);
            foreach (ITest child in test.Tests)
                ApplyTo(child);
        }

        public object Invoke(object fixture, params object[] args)
        {
            LogScope.Current.CheckAtEnd();
            LogScope.Begin();
            int limit = NUnit.Framework.TimeoutAttribute.Of(method.MethodInfo, method.TypeInfo.Type);
            var clock = Stopwatch.StartNew();

            object result = method.Invoke(fixture, args);
            if (IsCoroutine)
            {
                FramePlayer.Play((IEnumerator)result, limit == 0 ? FramePlayer.DefaultTimeout : limit);
                result = null;
            }
            else if (limit > 0 && clock.ElapsedMilliseconds > limit)
                throw FramePlayer.TookTooLong(limit);

            LogScope.Current.CheckAtEnd();
            if (MustExpectAllLogs())
                LogScope.Current.NoUnexpectedReceived();
            LogScope.Begin();
            return result;
        }

        public ITypeInfo ReturnType => IsCoroutine ? new TypeWrapper(typeof(void)) : method.ReturnType;

        public T[] GetCustomAttributes<T>(bool inherit) where T : class
        {
            T[] attributes = method.GetCustomAttributes<T>(inherit);
            if (typeof(T) != typeof(IWrapSetUpTearDown))
                return attributes;
            // NUnit wraps in this order, so the last is the outermost: around [SetUp] and [TearDown], as in Unity.
            Array.Resize(ref attributes, attributes.Length + 1);
            attributes[attributes.Length - 1] = (T)(object)new PlayedSetUpTearDown();
            return attributes;
        }

        bool IsCoroutine => method.MethodInfo.IsDefined(typeof(UnityTestAttribute), true);

        bool MustExpectAllLogs()
        {
            Type type = method.TypeInfo.Type;
            var attribute = method.MethodInfo.GetCustomAttribute<TestMustExpectAllLogsAttribute>()
                ?? type.GetCustomAttribute<TestMustExpectAllLogsAttribute>()
                ?? type.Assembly.GetCustomAttribute<TestMustExpectAllLogsAttribute>();
            return attribute != null && attribute.MustExpect;
        }

        public ITypeInfo TypeInfo => method.TypeInfo;
        public MethodInfo MethodInfo => method.MethodInfo;
        public string Name => method.Name;
        public bool IsAbstract => method.IsAbstract;
        public bool IsPublic => method.IsPublic;
        public bool ContainsGenericParameters => method.ContainsGenericParameters;
        public bool IsGenericMethod => method.IsGenericMethod;
        public bool IsGenericMethodDefinition => method.IsGenericMethodDefinition;
        public IParameterInfo[] GetParameters() => method.GetParameters();
        public Type[] GetGenericArguments() => method.GetGenericArguments();
        public IMethodInfo MakeGenericMethod(params Type[] typeArguments) => new PlayedMethod(method.MakeGenericMethod(typeArguments));
        public bool IsDefined<T>(bool inherit) => method.IsDefined<T>(inherit);
    }
}
