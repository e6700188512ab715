// Part of UnityCG.cginc here.
#include "UnityCG.cginc"
