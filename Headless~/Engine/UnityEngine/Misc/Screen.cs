using UnityEngine.Headless;

namespace UnityEngine
{
    public sealed class Screen
    {
        public static int width => Player.ScreenWidth;
        public static int height => Player.ScreenHeight;
        public static float dpi => 96;
        public static float brightness { get; set; } = 1;
        public static int sleepTimeout { get; set; } = -1;
        public static bool fullScreen { get; set; }
        public static FullScreenMode fullScreenMode { get; set; } = FullScreenMode.Windowed;
        public static ScreenOrientation orientation { get; set; } = ScreenOrientation.LandscapeLeft;
        public static Rect safeArea => new Rect(0, 0, width, height);
        public static Resolution currentResolution => new Resolution { width = width, height = height };
        public static Resolution[] resolutions => new[] { currentResolution };

        public static void SetResolution(int width, int height, bool fullscreen)
            => SetResolution(width, height, fullscreen ? FullScreenMode.FullScreenWindow : FullScreenMode.Windowed);

        public static void SetResolution(int width, int height, FullScreenMode fullscreenMode)
        {
            Player.ScreenWidth = width;
            Player.ScreenHeight = height;
            fullScreenMode = fullscreenMode;
        }
    }

    public enum FullScreenMode { ExclusiveFullScreen = 0, FullScreenWindow = 1, MaximizedWindow = 2, Windowed = 3 }
    public enum ScreenOrientation { Portrait = 1, PortraitUpsideDown = 2, LandscapeLeft = 3, LandscapeRight = 4, AutoRotation = 5 }

    public struct Resolution
    {
        public int width { get; set; }
        public int height { get; set; }
        public override string ToString() => $"{width} x {height}";
    }
}
