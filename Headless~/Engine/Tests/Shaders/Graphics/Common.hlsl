static const uint kCommon = 7;
