// For vertex programs of Graphics.RenderMeshIndirect and RenderPrimitivesIndirect (Scripting API, "Graphics.RenderMeshIndirect").
// Direct3D 11 counts SV_VertexID and SV_InstanceID from 0, and the engine draws the commands one by one.
// Written again for the headless host.
#ifndef UNITY_INDIRECT_INCLUDED
#define UNITY_INDIRECT_INCLUDED

uint unity_BaseCommandID;

void InitIndirectDrawArgs(uint svDrawID) { }
uint GetCommandID(uint svDrawID) { return unity_BaseCommandID + svDrawID; }
uint GetIndirectInstanceID(uint svInstanceID) { return svInstanceID; }
uint GetIndirectVertexID(uint svVertexID) { return svVertexID; }

#endif
