using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    public class Debug
    {
        static readonly Logger logger = new Logger(new LogSink());

        public static ILogger unityLogger => logger;
        public static bool isDebugBuild => true;
        public static bool developerConsoleEnabled { get; set; }
        public static bool developerConsoleVisible { get; set; }

        public static void Log(object message) => logger.Log(LogType.Log, message);
        public static void Log(object message, Object context) => logger.Log(LogType.Log, message, context);
        public static void LogFormat(string format, params object[] args) => logger.LogFormat(LogType.Log, format, args);
        public static void LogFormat(Object context, string format, params object[] args) => logger.LogFormat(LogType.Log, context, format, args);
        public static void LogFormat(LogType logType, LogOption logOptions, Object context, string format, params object[] args)
            => logger.LogFormat(logType, context, format, args);
        public static void LogWarning(object message) => logger.Log(LogType.Warning, message);
        public static void LogWarning(object message, Object context) => logger.Log(LogType.Warning, message, context);
        public static void LogWarningFormat(string format, params object[] args) => logger.LogFormat(LogType.Warning, format, args);
        public static void LogWarningFormat(Object context, string format, params object[] args)
            => logger.LogFormat(LogType.Warning, context, format, args);
        public static void LogError(object message) => logger.Log(LogType.Error, message);
        public static void LogError(object message, Object context) => logger.Log(LogType.Error, message, context);
        public static void LogErrorFormat(string format, params object[] args) => logger.LogFormat(LogType.Error, format, args);
        public static void LogErrorFormat(Object context, string format, params object[] args)
            => logger.LogFormat(LogType.Error, context, format, args);
        public static void LogException(Exception exception) => logger.LogException(exception, null);
        public static void LogException(Exception exception, Object context) => logger.LogException(exception, context);
        public static void LogAssertion(object message) => logger.Log(LogType.Assert, message);
        public static void LogAssertion(object message, Object context) => logger.Log(LogType.Assert, message, context);
        public static void LogAssertionFormat(string format, params object[] args) => logger.LogFormat(LogType.Assert, format, args);
        public static void LogAssertionFormat(Object context, string format, params object[] args)
            => logger.LogFormat(LogType.Assert, context, format, args);

        public static void Assert(bool condition) { if (!condition) LogAssertion("Assertion failed"); }
        public static void Assert(bool condition, Object context) { if (!condition) LogAssertion("Assertion failed", context); }
        public static void Assert(bool condition, object message) { if (!condition) LogAssertion(message); }
        public static void Assert(bool condition, string message) { if (!condition) LogAssertion(message); }
        public static void Assert(bool condition, object message, Object context) { if (!condition) LogAssertion(message, context); }
        public static void Assert(bool condition, string message, Object context) { if (!condition) LogAssertion(message, context); }
        public static void AssertFormat(bool condition, string format, params object[] args) { if (!condition) LogAssertionFormat(format, args); }
        public static void AssertFormat(bool condition, Object context, string format,
            params object[] args) { if (!condition) LogAssertionFormat(context, format, args); }

        // ---- no one looks: lines, pauses and the developer console
        public static void DrawLine(Vector3 start, Vector3 end) { }
        public static void DrawLine(Vector3 start, Vector3 end, Color color) { }
        public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration) { }
        public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration, bool depthTest) { }
        public static void DrawRay(Vector3 start, Vector3 dir) { }
        public static void DrawRay(Vector3 start, Vector3 dir, Color color) { }
        public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration) { }
        public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration, bool depthTest) { }
        public static void Break() { }
        public static void DebugBreak() { }
        public static void ClearDeveloperConsole() { }
    }

    public enum LogType { Error = 0, Assert = 1, Warning = 2, Log = 3, Exception = 4 }
    public enum LogOption { None = 0, NoStacktrace = 1 }
    public enum StackTraceLogType { None = 0, ScriptOnly = 1, Full = 2 }

    public interface ILogHandler
    {
        void LogFormat(LogType logType, Object context, string format, params object[] args);
        void LogException(Exception exception, Object context);
    }

    public interface ILogger : ILogHandler
    {
        ILogHandler logHandler { get; set; }
        bool logEnabled { get; set; }
        LogType filterLogType { get; set; }
        bool IsLogTypeAllowed(LogType logType);
        void Log(LogType logType, object message);
        void Log(LogType logType, object message, Object context);
        void Log(LogType logType, string tag, object message);
        void Log(LogType logType, string tag, object message, Object context);
        void Log(object message);
        void Log(string tag, object message);
        void Log(string tag, object message, Object context);
        void LogWarning(string tag, object message);
        void LogWarning(string tag, object message, Object context);
        void LogError(string tag, object message);
        void LogError(string tag, object message, Object context);
        void LogFormat(LogType logType, string format, params object[] args);
        void LogException(Exception exception);
    }

    public class Logger : ILogger
    {
        public Logger(ILogHandler logHandler) { this.logHandler = logHandler; }

        public ILogHandler logHandler { get; set; }
        public bool logEnabled { get; set; } = true;
        public LogType filterLogType { get; set; } = LogType.Log;

        public bool IsLogTypeAllowed(LogType logType)
            => logEnabled && (logType == LogType.Exception || filterLogType != LogType.Exception && logType <= filterLogType);

        static string Text(object message) => message switch
        {
            null => "Null",
            IFormattable formattable => formattable.ToString(null, System.Globalization.CultureInfo.InvariantCulture),
            _ => message.ToString(),
        };

        public void Log(LogType logType, object message) => Log(logType, message, null);
        public void Log(LogType logType, object message,
            Object context) { if (IsLogTypeAllowed(logType)) logHandler.LogFormat(logType, context, "{0}", Text(message)); }
        public void Log(LogType logType, string tag, object message) => Log(logType, tag, message, null);
        public void Log(LogType logType, string tag, object message,
            Object context) { if (IsLogTypeAllowed(logType)) logHandler.LogFormat(logType, context, "{0}: {1}", tag, Text(message)); }
        public void Log(object message) => Log(LogType.Log, message);
        public void Log(string tag, object message) => Log(LogType.Log, tag, message);
        public void Log(string tag, object message, Object context) => Log(LogType.Log, tag, message, context);
        public void LogWarning(string tag, object message) => Log(LogType.Warning, tag, message);
        public void LogWarning(string tag, object message, Object context) => Log(LogType.Warning, tag, message, context);
        public void LogError(string tag, object message) => Log(LogType.Error, tag, message);
        public void LogError(string tag, object message, Object context) => Log(LogType.Error, tag, message, context);
        public void LogFormat(LogType logType, string format, params object[] args) => LogFormat(logType, null, format, args);
        public void LogFormat(LogType logType, Object context, string format,
            params object[] args) { if (IsLogTypeAllowed(logType)) logHandler.LogFormat(logType, context, format, args); }
        public void LogException(Exception exception) => LogException(exception, null);
        public void LogException(Exception exception, Object context) { if (logEnabled) logHandler.LogException(exception, context); }
    }
}

namespace UnityEngine.Headless
{
    internal struct LogEntry
    {
        public LogType Type;
        public string Message, StackTrace;
        public Object Context;
        public Exception Exception;
        public override string ToString() => $"{Type}: {Message}";
    }

    /// <summary>End of all log messages: handlers of the host, then of the application, then the console.</summary>
    internal sealed class LogSink : ILogHandler
    {
        /// <summary>Every message, e.g. for a test run that fails on unexpected errors.</summary>
        public static event Action<LogEntry> Received;
        /// <summary>Prints; the host may replace it, or set null for silence.</summary>
        public static Action<LogEntry> Writer = ToConsole;

        public void LogFormat(LogType logType, Object context, string format, params object[] args)
            => Emit(new LogEntry { Type = logType, Message = args.Length == 0 ? format
                : string.Format(System.Globalization.CultureInfo.InvariantCulture, format, args), StackTrace = "", Context = context });

        public void LogException(Exception exception, Object context)
        {
            if (exception == null)
                throw new ArgumentNullException(nameof(exception));
            Emit(new LogEntry { Type = LogType.Exception, Message = $"{exception.GetType().Name}: {exception.Message}",
                StackTrace = exception.ToString(), Context = context, Exception = exception });
        }

        static void Emit(LogEntry entry)
        {
            Received?.Invoke(entry);
            Application.RaiseLogged(entry);
            Writer?.Invoke(entry);
        }

        static void ToConsole(LogEntry entry)
        {
            if (entry.Type == LogType.Log)
                Console.Out.WriteLine(entry.Message);
            else
                Console.Error.WriteLine(entry.Exception != null ? entry.StackTrace : $"{entry.Type}: {entry.Message}");
        }
    }
}
