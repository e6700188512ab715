using System;
using System.IO;
using System.Threading;
using UnityEngine.Events;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    public class Application
    {
        public delegate void LogCallback(string condition, string stackTrace, LogType type);
        public delegate void LowMemoryCallback();

        static CancellationTokenSource exit = new CancellationTokenSource();

        public static event LogCallback logMessageReceived;
        public static event LogCallback logMessageReceivedThreaded;
        public static event LowMemoryCallback lowMemory;
        public static event UnityAction onBeforeRender;
        public static event Action<bool> focusChanged;
        public static event Func<bool> wantsToQuit;
        public static event Action quitting;
        public static event Action unloading;

        /// <summary>The host ends its loop after the frame.</summary>
        internal static bool QuitRequested { get; private set; }
        internal static int ExitCode { get; private set; }

        public static bool isPlaying => !EditMode.IsOn;
        public static bool isEditor => EditMode.IsOn;
        public static bool isBatchMode => true;
        public static bool isFocused => true;
        public static bool isConsolePlatform => false;
        public static bool isMobilePlatform => Player.Limits.IsHandheld;
        public static bool runInBackground { get; set; } = true;
        public static bool genuine => true;
        public static bool genuineCheckAvailable => false;
        public static int targetFrameRate { get; set; } = -1;
        public static ThreadPriority backgroundLoadingPriority { get; set; } = ThreadPriority.Normal;
        /// <summary>Direct3D 11's conventions hold throughout, so that is the platform to claim.</summary>
        public static RuntimePlatform platform => RuntimePlatform.WindowsPlayer;
        public static SystemLanguage systemLanguage => SystemLanguage.English;
        public static NetworkReachability internetReachability => NetworkReachability.NotReachable;
        public static string unityVersion => "2022.3.0f1";
        public static string version => "1.0";
        public static string productName => Player.ProductName;
        public static string companyName => Player.CompanyName;
        public static string identifier => $"com.{Player.CompanyName}.{Player.ProductName}";
        public static string buildGUID => "00000000000000000000000000000000";
        public static string cloudProjectId => "";
        public static string installerName => "";
        public static string absoluteURL => "";
        public static string consoleLogPath => "";
        public static string dataPath => Path.Combine(Player.ProjectPath, "Assets");
        public static string streamingAssetsPath => Path.Combine(dataPath, "StreamingAssets");
        public static string persistentDataPath => Folder("persistent");
        public static string temporaryCachePath => Folder("cache");
        public static CancellationToken exitCancellationToken => exit.Token;

        // Unity creates these folders, so code that writes into them may rely on it.
        static string Folder(string kind)
            => Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), Player.CompanyName, Player.ProductName, kind)).FullName;

        public static bool IsPlaying(Object obj) => isPlaying && Object.IsAlive(obj) && !obj.IsAsset;
        public static bool HasProLicense() => true;
        public static void OpenURL(string url) { }
        public static StackTraceLogType GetStackTraceLogType(LogType logType) => StackTraceLogType.ScriptOnly;
        public static void SetStackTraceLogType(LogType logType, StackTraceLogType stackTraceType) { }
        public static bool CanStreamedLevelBeLoaded(int levelIndex) => levelIndex >= 0 && levelIndex < SceneManager.sceneCountInBuildSettings;

        public static void Quit() => Quit(0);

        public static void Quit(int exitCode)
        {
            if (wantsToQuit != null)
                foreach (Func<bool> asked in wantsToQuit.GetInvocationList())
                    if (!asked())
                        return;
            QuitRequested = true;
            ExitCode = exitCode;
        }

        /// <summary>By the host when its loop ends: OnApplicationQuit for all active scripts, then quitting.</summary>
        internal static void RaiseQuitting()
        {
            foreach (Object script in ObjectSearch.InScenes(typeof(MonoBehaviour), false))
                Messages.Send(script, Message.OnApplicationQuit);
            quitting?.Invoke();
            exit.Cancel();
        }

        internal static void RaiseBeforeRender() => onBeforeRender?.Invoke();

        internal static void RaiseLogged(in LogEntry entry)
        {
            logMessageReceived?.Invoke(entry.Message, entry.StackTrace, entry.Type);
            logMessageReceivedThreaded?.Invoke(entry.Message, entry.StackTrace, entry.Type);
        }

        internal static void ResetState()
        {
            QuitRequested = false;
            ExitCode = 0;
            targetFrameRate = -1;
            exit = new CancellationTokenSource();
            logMessageReceived = logMessageReceivedThreaded = null;
            lowMemory = null;
            onBeforeRender = null;
            focusChanged = null;
            wantsToQuit = null;
            quitting = unloading = null;
        }
    }

    public enum ThreadPriority { Low = 0, BelowNormal = 1, Normal = 2, High = 4 }
    public enum NetworkReachability { NotReachable = 0, ReachableViaCarrierDataNetwork = 1, ReachableViaLocalAreaNetwork = 2 }

    public enum RuntimePlatform
    {
        OSXEditor = 0, OSXPlayer = 1, WindowsPlayer = 2, WindowsEditor = 7, IPhonePlayer = 8, Android = 11, LinuxPlayer = 13, LinuxEditor = 16,
        WebGLPlayer = 17, WSAPlayerX86 = 18, WSAPlayerX64 = 19, WSAPlayerARM = 20, PS4 = 25, XboxOne = 27, tvOS = 31, Switch = 32,
        GameCoreXboxSeries = 36, GameCoreXboxOne = 37, PS5 = 38, EmbeddedLinuxArm64 = 39, EmbeddedLinuxX64 = 41, LinuxServer = 43,
        WindowsServer = 44, OSXServer = 45, QNXArm64 = 47, QNXX64 = 49, VisionOS = 50,
    }

    public enum SystemLanguage
    {
        Afrikaans, Arabic, Basque, Belarusian, Bulgarian, Catalan, Chinese, Czech, Danish, Dutch, English, Estonian, Faroese, Finnish, French,
        German, Greek, Hebrew, Hungarian, Icelandic, Indonesian, Italian, Japanese, Korean, Latvian, Lithuanian, Norwegian, Polish, Portuguese,
        Romanian, Russian, SerboCroatian, Slovak, Slovenian, Spanish, Swedish, Thai, Turkish, Ukrainian, Vietnamese, ChineseSimplified,
        ChineseTraditional, Unknown, Hindi,
    }
}

namespace UnityEngine.Events
{
    public delegate void UnityAction();
    public delegate void UnityAction<T0>(T0 arg0);
    public delegate void UnityAction<T0, T1>(T0 arg0, T1 arg1);
    public delegate void UnityAction<T0, T1, T2>(T0 arg0, T1 arg1, T2 arg2);
    public delegate void UnityAction<T0, T1, T2, T3>(T0 arg0, T1 arg1, T2 arg2, T3 arg3);
}
