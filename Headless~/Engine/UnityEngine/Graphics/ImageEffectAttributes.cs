using System;

// In Unity, ImageEffectOpaque would run an effect before the transparent objects; here every effect runs at the end.
namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Method)] public sealed class ImageEffectTransformsToLDR : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public sealed class ImageEffectOpaque : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public sealed class ImageEffectAfterScale : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public sealed class ImageEffectUsesCommandBuffer : Attribute { }
    [AttributeUsage(AttributeTargets.Class)] public sealed class ImageEffectAllowedInSceneView : Attribute { }
}
