#pragma once
#include "ui/widgets/theme.h"
