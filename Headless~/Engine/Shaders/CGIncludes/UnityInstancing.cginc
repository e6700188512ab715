// GPU instancing (manual, "Creating shaders that support GPU instancing"). Written again for the headless host.
// INSTANCING_ON: matrices and properties of each instance lie in arrays. PROCEDURAL_INSTANCING_ON: the shader's own function
// makes them. Properties are one array each, which is what the engine fills by name.
#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED

#ifndef UNITY_SHADER_VARIABLES_INCLUDED
#include "UnityShaderVariables.cginc"
#endif

#define UNITY_SUPPORT_INSTANCING
#if defined(INSTANCING_ON)
#define UNITY_INSTANCING_ENABLED
#endif
#if defined(PROCEDURAL_INSTANCING_ON)
#define UNITY_PROCEDURAL_INSTANCING_ENABLED
#endif

#if defined(UNITY_INSTANCING_ENABLED) || defined(UNITY_PROCEDURAL_INSTANCING_ENABLED)

#define UNITY_INSTANCED_ARRAY_SIZE 500
static uint unity_InstanceID;

#ifdef UNITY_INSTANCING_ENABLED
// Both together fill a constant buffer's 64 KB but for a little.
cbuffer UnityInstancing_PerDraw0
{
    float4x4 unity_ObjectToWorldArray[UNITY_INSTANCED_ARRAY_SIZE];
    float4x4 unity_WorldToObjectArray[UNITY_INSTANCED_ARRAY_SIZE];
};
#endif

#ifdef UNITY_INSTANCING_PROCEDURAL_FUNC
void UNITY_INSTANCING_PROCEDURAL_FUNC();
#endif

void UnitySetupInstance(uint instance)
{
    unity_InstanceID = instance;
#ifdef UNITY_INSTANCING_ENABLED
    unity_ObjectToWorld = unity_ObjectToWorldArray[instance];
    unity_WorldToObject = unity_WorldToObjectArray[instance];
#elif defined(UNITY_INSTANCING_PROCEDURAL_FUNC)
    UNITY_INSTANCING_PROCEDURAL_FUNC();
#endif
}

#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
#define UNITY_GET_INSTANCE_ID(input) input.instanceID
#define UNITY_SETUP_INSTANCE_ID(input) UnitySetupInstance(input.instanceID)
#define UNITY_TRANSFER_INSTANCE_ID(input, output) output.instanceID = input.instanceID
#define UNITY_INSTANCING_BUFFER_START(buffer) cbuffer UnityInstancing_##buffer {
#define UNITY_INSTANCING_BUFFER_END(buffer) };
#ifdef UNITY_INSTANCING_ENABLED
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name[UNITY_INSTANCED_ARRAY_SIZE];
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name[unity_InstanceID]
#else
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name
#endif

#else

#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_GET_INSTANCE_ID(input) 0
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#define UNITY_INSTANCING_BUFFER_START(buffer) cbuffer UnityInstancing_##buffer {
#define UNITY_INSTANCING_BUFFER_END(buffer) };
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name

#endif

// Stereo rendering is off.
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_VERTEX_OUTPUT_STEREO_EYE_INDEX
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_TRANSFER_VERTEX_OUTPUT_STEREO(input, output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)

#endif
