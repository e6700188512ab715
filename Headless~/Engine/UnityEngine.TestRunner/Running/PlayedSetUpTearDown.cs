using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Commands;
using UnityEngine.TestTools;

namespace UnityEngine.Headless
{
    /// <summary>Around a test: IOuterUnityTestAction, [UnitySetUp] and [UnityTearDown], and the log of what runs before and after it.</summary>
    internal sealed class PlayedSetUpTearDown : IWrapSetUpTearDown
    {
        public TestCommand Wrap(TestCommand command) => new Command(command);

        sealed class Command : DelegatingTestCommand
        {
            public Command(TestCommand inner) : base(inner) { }

            public override TestResult Execute(TestExecutionContext context)
            {
                LogScope.Begin();
                IOuterUnityTestAction[] actions = Test.Method.GetCustomAttributes<IOuterUnityTestAction>(true);
                try
                {
                    foreach (IOuterUnityTestAction action in actions)
                        FramePlayer.Play(action.BeforeTest(Test), FramePlayer.DefaultTimeout);
                    foreach (MethodInfo method in Methods(typeof(UnitySetUpAttribute)))
                        Play(method, context.TestObject);
                    context.CurrentResult = innerCommand.Execute(context);
                }
                catch (Exception error)
                {
                    context.CurrentResult.RecordException(error, FailureSite.SetUp);
                }

                After(context, () =>
                {
                    foreach (MethodInfo method in Methods(typeof(UnityTearDownAttribute)).Reverse())
                        Play(method, context.TestObject);
                });
                After(context, () =>
                {
                    foreach (IOuterUnityTestAction action in actions.Reverse())
                        FramePlayer.Play(action.AfterTest(Test), FramePlayer.DefaultTimeout);
                });
                // A test that failed has its reason; what it left in the log unexpected is the consequence.
                if (context.CurrentResult.ResultState.Status != TestStatus.Failed)
                    After(context, LogScope.Current.CheckAtEnd);
                LogScope.End();
                return context.CurrentResult;
            }

            static void After(TestExecutionContext context, Action work)
            {
                try { work(); }
                catch (Exception error) { context.CurrentResult.RecordTearDownException(error); }
            }

            static void Play(MethodInfo method, object fixture)
            {
                if (method.ReturnType != typeof(IEnumerator))
                    throw new InvalidOperationException(
                        $"{method.DeclaringType.Name}.{method.Name}: a [UnitySetUp] or [UnityTearDown] must return IEnumerator.");
                FramePlayer.Play((IEnumerator)Reflect.InvokeMethod(method, fixture), FramePlayer.DefaultTimeout);
            }

            // Those of base classes first.
            IEnumerable<MethodInfo> Methods(Type attribute)
            {
                var types = new List<Type>();
                for (Type type = Test.TypeInfo.Type; type != null; type = type.BaseType)
                    types.Insert(0, type);
                return types.SelectMany(type => type.GetMethods(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic
                    | BindingFlags.DeclaredOnly))
                    .Where(method => method.IsDefined(attribute, false));
            }
        }
    }
}
