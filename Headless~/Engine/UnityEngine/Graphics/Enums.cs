using System;

// Enumerations of the graphics API; the numbers are Unity's, since they stand in scene and material files.
namespace UnityEngine
{
    public enum CubemapFace { Unknown = -1, PositiveX, NegativeX, PositiveY, NegativeY, PositiveZ, NegativeZ }
    public enum FilterMode { Point, Bilinear, Trilinear }
    public enum TextureWrapMode { Repeat, Clamp, Mirror, MirrorOnce }
    public enum AnisotropicFiltering { Disable, Enable, ForceEnable }
    public enum MeshTopology { Triangles = 0, Quads = 2, Lines = 3, LineStrip = 4, Points = 5 }
    public enum MotionVectorGenerationMode { Camera, Object, ForceNoMotion }
    public enum RenderTextureReadWrite { Default, Linear, sRGB }
    [Flags] public enum RenderTextureMemoryless { None = 0, Color = 1, Depth = 2, MSAA = 4 }
    public enum VRTextureUsage { None, OneEye, TwoEyes, DeviceSpecific }
    [Flags] public enum RenderTextureCreationFlags
    {
        MipMap = 1, AutoGenerateMips = 2, SRGB = 4, EyeTexture = 8, EnableRandomWrite = 16, CreatedFromScript = 32,
        AllowVerticalFlip = 128, NoResolvedColorSurface = 256, DynamicallyScalable = 1024, BindMS = 2048,
    }
    [Flags] public enum DepthTextureMode { None = 0, Depth = 1, DepthNormals = 2, MotionVectors = 4 }
    public enum LightType { Spot, Directional, Point, Rectangle, Disc }
    public enum LightShadows { None, Hard, Soft }
    public enum ShadowProjection { CloseFit = 0, StableFit = 1 }
    public enum LightRenderMode { Auto, ForcePixel, ForceVertex }
    public enum FogMode { Linear = 1, Exponential, ExponentialSquared }
    public enum ColorSpace { Uninitialized = -1, Gamma, Linear }
    public enum ShadowQuality { Disable, HardOnly, All }
    public enum ShadowResolution { Low, Medium, High, VeryHigh }
    public enum RenderingPath { UsePlayerSettings = -1, VertexLit = 0, Forward = 1, DeferredShading = 3 }
    public enum TransparencySortMode { Default, Perspective, Orthographic, CustomAxis }
    [Flags] public enum MaterialGlobalIlluminationFlags { None = 0, RealtimeEmissive = 1, BakedEmissive = 2, EmissiveIsBlack = 4, AnyEmissive = 3 }
    public enum MaterialPropertyType { Float, Int, Vector, Matrix, Texture, ConstantBuffer, ComputeBuffer }
    public enum CameraClearFlags { Skybox = 1, Color = 2, SolidColor = 2, Depth = 3, Nothing = 4 }
    [Flags] public enum CameraType { Game = 1, SceneView = 2, Preview = 4, VR = 8, Reflection = 16 }
    public enum NPOTSupport { Restricted = 1, Full = 2 }

    [Flags] public enum ComputeBufferType { Default = 0, Raw = 1, Append = 2, Counter = 4, Constant = 8, Structured = 16, IndirectArguments = 256 }
    public enum ComputeBufferMode { Immutable = 0, Dynamic = 1, SubUpdates = 4 }

    public enum TextureFormat
    {
        Alpha8 = 1, ARGB4444, RGB24, RGBA32, ARGB32, RGB565 = 7, R16 = 9, DXT1, DXT5 = 12, RGBA4444, BGRA32, RHalf, RGHalf, RGBAHalf,
        RFloat, RGFloat, RGBAFloat, YUY2, RGB9e5Float, BC6H = 24, BC7, BC4, BC5, DXT1Crunched, DXT5Crunched,
        PVRTC_RGB2, PVRTC_RGBA2, PVRTC_RGB4, PVRTC_RGBA4, ETC_RGB4, EAC_R = 41, EAC_R_SIGNED, EAC_RG, EAC_RG_SIGNED,
        ETC2_RGB, ETC2_RGBA1, ETC2_RGBA8, ASTC_4x4, ASTC_5x5, ASTC_6x6, ASTC_8x8, ASTC_10x10, ASTC_12x12,
        RG16 = 62, R8, ETC_RGB4Crunched, ETC2_RGBA8Crunched, ASTC_HDR_4x4, ASTC_HDR_5x5, ASTC_HDR_6x6, ASTC_HDR_8x8,
        ASTC_HDR_10x10, ASTC_HDR_12x12, RG32, RGB48, RGBA64,
    }

    public enum RenderTextureFormat
    {
        ARGB32, Depth, ARGBHalf, Shadowmap, RGB565, ARGB4444, ARGB1555, Default, ARGB2101010, DefaultHDR, ARGB64, ARGBFloat, RGFloat,
        RGHalf, RFloat, RHalf, R8, ARGBInt, RGInt, RInt, BGRA32, RGB111110Float = 22, RG32, RGBAUShort, RG16, BGRA10101010_XR,
        BGR101010_XR, R16,
    }
}

namespace UnityEngine.Rendering
{
    public enum BuiltinRenderTextureType
    {
        PropertyName = -4, BufferPtr = -3, RenderTexture = -2, BindableTexture = -1, None = 0, CurrentActive = 1, CameraTarget = 2, Depth = 3,
        DepthNormals = 4, ResolvedDepth = 5, GBuffer0 = 10, GBuffer1, GBuffer2, GBuffer3, Reflections, MotionVectors, GBuffer4, GBuffer5,
        GBuffer6, GBuffer7,
    }
    public enum TextureDimension { Unknown = -1, None, Any, Tex2D, Tex3D, Cube, Tex2DArray, CubeArray }
    public enum ShadowCastingMode { Off, On, TwoSided, ShadowsOnly }
    public enum LightProbeUsage { Off = 0, BlendProbes = 1, UseProxyVolume = 2, CustomProvided = 4 }
    public enum ReflectionProbeUsage { Off, BlendProbes, BlendProbesAndSkybox, Simple }
    public enum ReflectionProbeMode { Baked, Realtime, Custom }
    public enum ShadowSamplingMode { CompareDepths, RawDepth, None }
    public enum RenderTextureSubElement { Color, Depth, Stencil, Default }
    public enum ShaderPropertyType { Color, Vector, Float, Range, Texture, Int }
    [Flags] public enum ShaderPropertyFlags
    {
        None = 0, HideInInspector = 1, PerRendererData = 2, NoScaleOffset = 4, Normal = 8, HDR = 16, Gamma = 32,
        NonModifiableTextureData = 64, MainTexture = 128, MainColor = 256,
    }
    public enum ShaderKeywordType { None = 0, BuiltinDefault = 2, UserDefined = 16, Plugin = 32 }
    public enum CompareFunction { Disabled, Never, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always }
    public enum BlendMode { Zero, One, DstColor, SrcColor, OneMinusDstColor, SrcAlpha, OneMinusSrcColor, DstAlpha, OneMinusDstAlpha,
        SrcAlphaSaturate, OneMinusSrcAlpha }
    public enum BlendOp { Add, Subtract, ReverseSubtract, Min, Max }
    public enum CullMode { Off, Front, Back }
    [Flags] public enum ColorWriteMask { Alpha = 1, Blue = 2, Green = 4, Red = 8, All = 15 }
    public enum DefaultReflectionMode { Skybox, Custom }
    public enum AmbientMode { Skybox = 0, Trilight = 1, Flat = 3, Custom = 4 }
    public enum ComputeQueueType { Default, Background, Urgent }
    [Flags] public enum CommandBufferExecutionFlags { None = 0, AsyncCompute = 2 }
    public enum RenderBufferLoadAction { Load, Clear, DontCare }
    public enum RenderBufferStoreAction { Store, Resolve, StoreAndResolve, DontCare }
    [Flags] public enum RTClearFlags { None = 0, Color = 1, Depth = 2, Stencil = 4, All = 7, DepthStencil = 6, ColorDepth = 3, ColorStencil = 5 }
    public enum IndexFormat { UInt16, UInt32 }
    public enum VertexAttribute { Position, Normal, Tangent, Color, TexCoord0, TexCoord1, TexCoord2, TexCoord3, TexCoord4, TexCoord5,
        TexCoord6, TexCoord7, BlendWeight, BlendIndices }
    public enum VertexAttributeFormat { Float32, Float16, UNorm8, SNorm8, UNorm16, SNorm16, UInt8, SInt8, UInt16, SInt16, UInt32, SInt32 }
    [Flags] public enum MeshUpdateFlags { Default = 0, DontValidateIndices = 1, DontResetBoneBounds = 2, DontNotifyMeshUsers = 4,
        DontRecalculateBounds = 8 }
    public enum RenderQueue { Background = 1000, Geometry = 2000, AlphaTest = 2450, GeometryLast = 2500, Transparent = 3000, Overlay = 4000 }
    [Flags] public enum CopyTextureSupport { None = 0, Basic = 1, Copy3D = 2, DifferentTypes = 4, TextureToRT = 8, RTToTexture = 16 }
    public enum RenderingThreadingMode { Direct, SingleThreaded, MultiThreaded, LegacyJobified, NativeGraphicsJobs,
        NativeGraphicsJobsWithoutRenderThread }
    public enum OpaqueSortMode { Default, FrontToBack, NoDistanceSort }
    public enum GraphicsFenceType { AsyncQueueSynchronisation, CPUSynchronisation }
    [Flags] public enum SynchronisationStageFlags { VertexProcessing = 1, PixelProcessing = 2, ComputeProcessing = 4, AllGPUOperations = 7 }
    public enum SynchronisationStage { VertexProcessing, PixelProcessing }
    public enum LightEvent { BeforeShadowMap, AfterShadowMap, BeforeScreenspaceMask, AfterScreenspaceMask, BeforeShadowMapPass, AfterShadowMapPass }
    public enum GraphicsDeviceType
    {
        Direct3D11 = 2, Null = 4, OpenGLES3 = 11, PlayStation4 = 13, XboxOne = 14, Metal = 16, OpenGLCore = 17, Direct3D12 = 18, Vulkan = 21,
        Switch = 22, XboxOneD3D12 = 23, GameCoreXboxOne = 24, GameCoreXboxSeries = 25, PlayStation5 = 26, PlayStation5NGGC = 27,
    }
    public enum CameraEvent
    {
        BeforeDepthTexture, AfterDepthTexture, BeforeDepthNormalsTexture, AfterDepthNormalsTexture, BeforeGBuffer, AfterGBuffer, BeforeLighting,
        AfterLighting, BeforeFinalPass, AfterFinalPass, BeforeForwardOpaque, AfterForwardOpaque, BeforeImageEffectsOpaque,
        AfterImageEffectsOpaque, BeforeSkybox, AfterSkybox, BeforeForwardAlpha, AfterForwardAlpha, BeforeImageEffects, AfterImageEffects,
        AfterEverything, BeforeReflections, AfterReflections, BeforeHaloAndLensFlares, AfterHaloAndLensFlares,
    }
}

namespace UnityEngine
{
    public enum DeviceType { Unknown, Handheld, Console, Desktop }
}

namespace UnityEngine.Experimental.Rendering
{
    public enum DefaultFormat { LDR, HDR, DepthStencil, Shadow, Video }
    [Flags] public enum TextureCreationFlags { None = 0, MipChain = 1, DontInitializePixels = 4, Crunch = 64, DontUploadUponCreate = 1024 }

    public enum GraphicsFormat
    {
        None,
        R8_SRGB, R8G8_SRGB, R8G8B8_SRGB, R8G8B8A8_SRGB, R8_UNorm, R8G8_UNorm, R8G8B8_UNorm, R8G8B8A8_UNorm,
        R8_SNorm, R8G8_SNorm, R8G8B8_SNorm, R8G8B8A8_SNorm, R8_UInt, R8G8_UInt, R8G8B8_UInt, R8G8B8A8_UInt,
        R8_SInt, R8G8_SInt, R8G8B8_SInt, R8G8B8A8_SInt,
        R16_UNorm, R16G16_UNorm, R16G16B16_UNorm, R16G16B16A16_UNorm, R16_SNorm, R16G16_SNorm, R16G16B16_SNorm, R16G16B16A16_SNorm,
        R16_UInt, R16G16_UInt, R16G16B16_UInt, R16G16B16A16_UInt, R16_SInt, R16G16_SInt, R16G16B16_SInt, R16G16B16A16_SInt,
        R32_UInt, R32G32_UInt, R32G32B32_UInt, R32G32B32A32_UInt, R32_SInt, R32G32_SInt, R32G32B32_SInt, R32G32B32A32_SInt,
        R16_SFloat, R16G16_SFloat, R16G16B16_SFloat, R16G16B16A16_SFloat, R32_SFloat, R32G32_SFloat, R32G32B32_SFloat, R32G32B32A32_SFloat,
        B8G8R8_SRGB = 56, B8G8R8A8_SRGB, B8G8R8_UNorm, B8G8R8A8_UNorm,
        B10G11R11_UFloatPack32 = 74, A2B10G10R10_UNormPack32 = 75,
        D16_UNorm = 90, D24_UNorm, D24_UNorm_S8_UInt, D32_SFloat, D32_SFloat_S8_UInt, S8_UInt,
        D16_UNorm_S8_UInt = 151,
    }
}
